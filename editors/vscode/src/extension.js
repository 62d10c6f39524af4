// What the extension does wherever it runs: it starts the language server, and shows beside the
// text the diagram of the operation under the cursor. All answers are the server's.

const vscode = require("vscode");

let running;
let panel;

exports.settings = () => vscode.workspace.getConfiguration("hedgerow");

exports.options = () => ({
  documentSelector: [{ language: "hedgerow" }],
  synchronize: {
    configurationSection: "hedgerow",
    fileEvents: vscode.workspace.createFileSystemWatcher("**/*.hedge"),
  },
  // Pictures in hovers are images of markdown.
  markdown: { isTrusted: true, supportHtml: true },
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
  register("showDiagram", () => showDiagram(context));
  for (const [name, action] of Object.entries(commands)) register(name, action);
  let pause;
  const later = () => {
    clearTimeout(pause);
    pause = setTimeout(draw, 150);
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

function showDiagram(context) {
  if (panel) {
    panel.reveal(undefined, true);
  } else {
    const beside = { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true };
    panel = vscode.window.createWebviewPanel("hedgerow.diagram", "Diagram", beside, {});
    panel.onDidDispose(() => { panel = undefined; }, undefined, context.subscriptions);
  }
  return draw();
}

/** Shows the operation under the cursor; where there is none, the last one stays. */
async function draw() {
  const editor = vscode.window.activeTextEditor;
  if (!panel || !running || editor?.document.languageId !== "hedgerow") return;
  let answer;
  try {
    answer = await running.sendRequest("hedgerow/diagram", {
      textDocument: { uri: editor.document.uri.toString() },
      position: { line: editor.selection.active.line, character: editor.selection.active.character },
    });
  } catch (error) {
    if (!panel.webview.html) panel.webview.html = page(`<p>${escaped(error.message)}</p>`);
    return;
  }
  const svg = typeof answer === "string" ? answer : answer?.svg;
  if (!panel) return;
  if (svg) {
    panel.title = answer.name ? `Diagram: ${answer.name}` : "Diagram";
    panel.webview.html = page(svg);
  } else if (!panel.webview.html) {
    panel.webview.html = page("<p>Put the cursor into an operation.</p>");
  }
}

const escaped = (text) => String(text).replace(/[&<>]/g, (sign) => `&#${sign.charCodeAt(0)};`);

// The pictures are drawn for paper.
const page = (body) => `<!DOCTYPE html>
<html>
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; img-src data:;">
<style>
body { background: white; color: black; margin: 0; padding: 12px; }
svg { display: block; width: 100%; height: auto; max-height: 95vh; }
</style>
</head>
<body>${body}</body>
</html>`;
