// The extension where programs can be started.

const vscode = require("vscode");
const {
  LanguageClient, PortMessageReader, PortMessageWriter,
} = require("vscode-languageclient/node");
const { execFile } = require("child_process");
const path = require("path");
const { Worker } = require("worker_threads");
const { start, options, settings } = require("./extension");

/** Whether the program answers. */
function isInstalled(command) {
  return new Promise((resolve) => {
    execFile(command, ["--version"], { timeout: 10000 }, (error) => resolve(!error));
  });
}

/** The server that comes along, in a thread of its own. */
function bundled(context) {
  const place = (name) => context.asAbsolutePath(path.join("dist", name));
  return async () => {
    const worker = new Worker(place("server-node.js"));
    worker.postMessage({ module: place("hedgerow.wasm") });
    return { reader: new PortMessageReader(worker), writer: new PortMessageWriter(worker) };
  };
}

let program;

/** The program of the setting, or of `PATH`; if neither answers, what comes along. */
async function answers() {
  const wanted = settings().get("path");
  const command = wanted || "hedgerow";
  program = await isInstalled(command) ? command : undefined;
  if (!program && wanted && wanted !== "hedgerow") {
    const choice = await vscode.window.showWarningMessage(
      `The program "${wanted}" of hedgerow.path does not start. The server of the extension is used.`,
      "Open Setting",
    );
    if (choice) vscode.commands.executeCommand("workbench.action.openSettings", "hedgerow.path");
  }
  return true;
}

const client = (context) => () => {
  const server = program ? { command: program, args: ["lsp"] } : bundled(context);
  return new LanguageClient("hedgerow", "hedgerow", server, options({
    "hedgerow.runTest": async (uri, name) => {
      const path = await saved(vscode.Uri.parse(uri));
      if (path) await runTest(path, name);
    },
    "hedgerow.runScript": async (uri, name) => {
      const path = await saved(vscode.Uri.parse(uri));
      if (path) await runScript(path, name);
    },
  }));
};

/** Runs hedgerow in a terminal, as a task, so that the arguments need no quoting. */
async function run(title, args) {
  if (!program) {
    vscode.window.showInformationMessage(
      "Scripts and tests run in the program hedgerow: install it (cargo install --path . in a copy "
      + "of hedgerow), or set hedgerow.path.",
    );
    return;
  }
  const command = program;
  const task = new vscode.Task(
    { type: "hedgerow" }, vscode.TaskScope.Workspace, title, "hedgerow",
    new vscode.ProcessExecution(command, args), [],
  );
  task.presentationOptions = { clear: true, showReuseMessage: false };
  return vscode.tasks.executeTask(task);
}

/** The file of a document, saved. */
async function saved(uri) {
  const document = await vscode.workspace.openTextDocument(uri);
  return await document.save() ? uri.fsPath : undefined;
}

/** The file of the editor, saved. */
async function file() {
  const document = vscode.window.activeTextEditor?.document;
  return document?.languageId === "hedgerow" ? await saved(document.uri) : undefined;
}

async function check() {
  const program = await file();
  if (program) await run("check", ["check", program]);
}

const runTest = (path, name) => run("test", name ? ["test", path, `--filter=${name}`, "--exact"] : ["test", path]);

async function testHere() {
  const path = await file();
  if (path) await runTest(path);
}

/** Asks for a mesh and a place for the result. */
async function runScript(path, name) {
  const filters = { Meshes: ["obj", "ply", "stl", "off", "msh", "halfedges"] };
  const mesh = await vscode.window.showOpenDialog({ filters, title: "The mesh to run it on" });
  if (!mesh) return;
  const output = await vscode.window.showSaveDialog({ filters, title: "Where to write the result" });
  if (!output) return;
  await run(`run ${name}`, ["run", `${path}::${name}`, mesh[0].fsPath, "-o", output.fsPath]);
}

async function runScriptHere() {
  const path = await file();
  if (!path) return;
  const { uri } = vscode.window.activeTextEditor.document;
  const lenses = await vscode.commands.executeCommand("vscode.executeCodeLensProvider", uri) ?? [];
  const scripts = lenses.map((lens) => lens.command).filter((command) => command?.command === "hedgerow.runScript");
  const names = scripts.map((command) => command.arguments[1]);
  if (names.length === 0) {
    vscode.window.showInformationMessage("This file has no script.");
    return;
  }
  const name = names.length === 1 ? names[0] : await vscode.window.showQuickPick(names);
  if (name) await runScript(path, name);
}

exports.activate = (context) => start(context, {
  client: client(context), isBundled: () => !program, answers, commands: { check, testHere, runScriptHere },
});
exports.deactivate = require("./extension").stop;
