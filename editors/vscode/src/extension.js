// What the extension does wherever it runs: it starts the language server, and shows beside the
// text the diagram of the operation under the cursor. All answers are the server's.

const vscode = require("vscode");

let running;
let panel;

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

exports.start = async (context, { client, answers, commands }) => {
  const begin = async () => {
    await exports.stop();
    if (!await answers()) return;
    running = client();
    try {
      await running.start();
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
  for (const [name, action] of Object.entries(commands)) register(name, action);
  let pause;
  const later = () => {
    clearTimeout(pause);
    pause = setTimeout(() => draw(), 150);
  };
  context.subscriptions.push(
    vscode.window.onDidChangeTextEditorSelection(later),
    vscode.workspace.onDidChangeTextDocument(later),
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
function showDiagram(of) {
  if (panel) {
    panel.reveal(undefined, true);
  } else {
    const beside = { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true };
    panel = vscode.window.createWebviewPanel("hedgerow.diagram", "Diagram", beside, {});
    panel.onDidDispose(() => { panel = undefined; });
  }
  return draw(of);
}

/** Where there is no operation, the last one stays. */
async function draw(of) {
  const editor = vscode.window.activeTextEditor;
  const here = editor?.document.languageId === "hedgerow";
  if (!panel || !running || (!of && !here)) return;
  let answer;
  try {
    answer = await running.sendRequest("hedgerow/diagram", of
      ? { textDocument: { uri: of.uri }, name: of.name }
      : { textDocument: { uri: editor.document.uri.toString() }, position: editor.selection.active });
  } catch (error) {
    if (panel && !panel.webview.html) panel.webview.html = page(`<p>${escaped(error.message)}</p>`);
    return;
  }
  if (!panel) return;
  if (answer) {
    panel.title = `Diagram: ${answer.name}`;
    const old = answer.isCurrent ? "" : "<p>(as it was when it could last be read)</p>";
    panel.webview.html = page(answer.svg + old + markdown(answer.verdict));
  } else if (!panel.webview.html) {
    panel.webview.html = page("<p>Put the cursor into an operation.</p>");
  }
}

const escaped = (text) => String(text).replace(/[&<>]/g, (sign) => `&#${sign.charCodeAt(0)};`);

/** Lines of Markdown: what is bold, code, an item of a list; all else is text. */
const markdown = (text) => text.split("\n").filter((line) => line.trim()).map((line) => `<p>${
  escaped(line.replace(/^- /, "\u2022 "))
    .replace(/\*\*([^*]+)\*\*/g, "<b>$1</b>")
    .replace(/`([^`]+)`/g, "<code>$1</code>")
}</p>`).join("");

// The pictures are drawn for paper, and for a dark page where such pages are preferred.
const page = (body) => `<!DOCTYPE html>
<html>
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; img-src data:;">
<style>
body { background: white; color: #22262c; margin: 0; padding: 12px; font-size: 14px; }
@media (prefers-color-scheme: dark) { body { background: #15181d; color: #d9dee5; } }
p { margin: 6px 0; }
code { color: inherit; background: none; font-family: monospace; }
svg { display: block; width: 100%; height: auto; max-height: 90vh; }
</style>
</head>
<body>${body}</body>
</html>`;
