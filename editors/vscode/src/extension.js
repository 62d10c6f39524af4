// What the extension does wherever it runs: it starts the language server, and shows beside the
// text the diagram of the operation under the cursor, and a mesh to try it on.

const vscode = require("vscode");
const { Panel } = require("./panel");
const { give, read } = require("./files");

let running;
let panel;
let open;

exports.settings = () => vscode.workspace.getConfiguration("hedgerow");

/** Settings of the client; `lenses` are actions for the commands behind code lenses. */
exports.options = (lenses = {}) => ({
  documentSelector: [{ language: "hedgerow" }],
  synchronize: {
    configurationSection: "hedgerow",
    fileEvents: vscode.workspace.createFileSystemWatcher("**/*.hedge"),
  },
  // What a hover says comes from programs that others wrote: no link in it runs a command, and
  // nothing in it is HTML. Pictures are images of Markdown, for which no trust is needed.
  markdown: { isTrusted: false, supportHtml: false },
  // What the server would show on a page or run unseen is shown and run here.
  middleware: {
    executeCommand: (command, [uri, name, ...rest], next) => {
      if (command === "hedgerow.showDiagram") return showDiagram({ uri, name });
      const lens = lenses[command];
      return lens && rest.length === 0 ? lens(uri, name) : next(command, [uri, name, ...rest]);
    },
  },
});

exports.start = async (context, { client, answers, commands, isBundled }) => {
  const begin = async () => {
    await exports.stop();
    if (!await answers()) return;
    try {
      running = await client();
      await running.start();
      if (isBundled()) await give(running);
    } catch (error) {
      running = undefined;
      vscode.window.showErrorMessage(`The language server of hedgerow does not start: ${error.message ?? error}`);
    }
  };
  const register = (name, action) => context.subscriptions.push(
    vscode.commands.registerCommand(`hedgerow.${name}`, action),
  );
  register("restart", begin);
  register("diagramBeside", () => showDiagram());
  open = () => new Panel(context.extensionUri, () => { panel = undefined; });
  for (const [name, action] of Object.entries(commands)) register(name, action);
  let pause;
  const later = () => {
    clearTimeout(pause);
    pause = setTimeout(() => draw(), 150);
  };
  context.subscriptions.push(
    vscode.window.onDidChangeTextEditorSelection(later),
    vscode.workspace.onDidChangeTextDocument(later),
    vscode.window.onDidChangeActiveTextEditor(later),
    vscode.workspace.onDidChangeConfiguration((change) => {
      if (change.affectsConfiguration("hedgerow.path")) begin();
    }),
  );
  await begin();
};

exports.stop = async () => {
  const last = running;
  running = undefined;
  try {
    await last?.stop();
  } catch {
    // It has gone by itself.
  }
};

/** Shows a named operation of a document, or the one under the cursor. */
async function showDiagram(of) {
  if (panel) panel.reveal();
  else panel = open();
  await panel.ready;
  return draw(of);
}

/** Where there is no operation, the last one stays. */
async function draw(of) {
  const editor = vscode.window.activeTextEditor;
  const here = editor?.document.languageId === "hedgerow";
  const shown = panel;
  if (!shown || !running || (!of && !here)) return;
  const uri = of ? vscode.Uri.parse(of.uri) : editor.document.uri;
  // As plain data: to a worker objects are handed by their fields.
  const { line, character } = editor?.selection.active ?? {};
  try {
    const answer = await running.sendRequest("hedgerow/diagram", of
      ? { textDocument: { uri: of.uri }, name: of.name }
      : { textDocument: { uri: uri.toString() }, position: { line, character } });
    await shown.program(uri, read);
    shown.diagram(answer);
  } catch (error) {
    shown.fail(error.message);
  }
}
