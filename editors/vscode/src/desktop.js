// The extension where programs can be started.

const vscode = require("vscode");
const { LanguageClient } = require("vscode-languageclient/node");
const { execFile } = require("child_process");
const { start, options, settings } = require("./extension");

function client() {
  const command = settings().get("path") || "hedgerow";
  return new LanguageClient("hedgerow", "hedgerow", { command, args: ["lsp"] }, options({
    "hedgerow.runTest": (uri, name) => runTest(vscode.Uri.parse(uri).fsPath, name),
    "hedgerow.runScript": (uri, name) => runScript(vscode.Uri.parse(uri).fsPath, name),
  }));
}

/** Whether the program answers; if not, says what to do. */
function answers() {
  const command = settings().get("path") || "hedgerow";
  return new Promise((resolve) => {
    execFile(command, ["--version"], { timeout: 10000 }, (error) => {
      if (!error) return resolve(true);
      const why = error.code === "ENOENT"
        ? `There is no program "${command}".`
        : `The program "${command}" does not start: ${error.message}`;
      const choices = ["Open Setting", "Try Again"];
      const install = "Colours and snippets work without it. For everything else, install it "
        + "(cargo install --path . in a copy of hedgerow), or set hedgerow.path.";
      vscode.window.showErrorMessage(`${why} ${install}`, ...choices).then((choice) => {
        if (choice === "Open Setting") {
          vscode.commands.executeCommand("workbench.action.openSettings", "hedgerow.path");
        } else if (choice === "Try Again") {
          vscode.commands.executeCommand("hedgerow.restart");
        }
      });
      resolve(false);
    });
  });
}

/** Runs hedgerow in a terminal, as a task, so that the arguments need no quoting. */
function run(title, args) {
  const command = settings().get("path") || "hedgerow";
  const task = new vscode.Task(
    { type: "hedgerow" }, vscode.TaskScope.Workspace, title, "hedgerow",
    new vscode.ProcessExecution(command, args), [],
  );
  task.presentationOptions = { clear: true, showReuseMessage: false };
  return vscode.tasks.executeTask(task);
}

/** The file of the editor, saved. */
async function file() {
  const document = vscode.window.activeTextEditor?.document;
  if (document?.languageId !== "hedgerow") return undefined;
  return await document.save() ? document.uri.fsPath : undefined;
}

async function check() {
  const path = await file();
  if (path) await run("check", ["check", path]);
}

const runTest = (path, name) => run("test", name ? ["test", path, `--filter=${name}`] : ["test", path]);

async function testHere() {
  const path = await file();
  if (path) await runTest(path);
}

/** Asks for a mesh and a place for the result. */
async function runScript(path, name) {
  const filters = { Meshes: ["obj"] };
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

exports.activate = (context) => start(context, { client, answers, commands: { check, testHere, runScriptHere } });
exports.deactivate = require("./extension").stop;
