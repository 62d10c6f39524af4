// The panel beside the text: the diagram of an operation, and below it a mesh in 3D to try it on. The
// page in it is built with that of the browser (`web/src/panel.js`).

const vscode = require("vscode");

/** The files that a program uses, by the letter: `use "part.hedge"`. */
const USES = /^[ \t]*use[ \t]+"([^"\n]+)"/gm;
/** The most files that one program is shown with. */
const MOST = 100;

exports.Panel = class {
  /** Promises that the page listens. */
  ready;
  #panel;

  constructor(extension, gone) {
    const beside = { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true };
    const dist = vscode.Uri.joinPath(extension, "dist");
    this.#panel = vscode.window.createWebviewPanel("hedgerow.diagram", "Diagram", beside, {
      enableScripts: true, retainContextWhenHidden: true, localResourceRoots: [dist],
    });
    const { webview } = this.#panel;
    this.ready = new Promise((listens) => webview.onDidReceiveMessage(listens));
    this.#panel.onDidDispose(gone);
    webview.html = page(webview, dist);
  }

  reveal() {
    this.#panel.reveal(undefined, true);
  }

  /** Shows the program of an address, with those that it uses. */
  async program(uri, read) {
    const text = await read(uri);
    if (text === undefined) return;
    const files = {};
    const open = [[uri, text]];
    while (open.length > 0 && Object.keys(files).length < MOST) {
      const [here, body] = open.pop();
      for (const [, path] of body.matchAll(USES)) {
        if (path.startsWith("std/")) continue;
        const used = path.startsWith("/")
          ? here.with({ path }) : vscode.Uri.joinPath(here, "..", path);
        if (used.path in files) continue;
        const part = await read(used);
        if (part === undefined) continue;
        files[used.path] = part;
        open.push([used, part]);
      }
    }
    this.#tell({ program: { name: uri.path, text, files } });
  }

  /** Shows the diagram of an operation; where there is none, the last one stays. */
  diagram(diagram) {
    if (diagram) {
      this.#panel.title = `Diagram: ${diagram.name}`;
      this.#tell({ diagram });
      this.isFilled = true;
    } else if (!this.isFilled) {
      this.#tell({ note: "Put the cursor into an operation." });
    }
  }

  fail(message) {
    if (!this.isFilled) this.#tell({ note: message });
  }

  #tell(message) {
    this.#panel.webview.postMessage(message);
  }
};

const page = (webview, dist) => {
  const place = (name) => webview.asWebviewUri(vscode.Uri.joinPath(dist, name));
  const own = webview.cspSource;
  const policy = `default-src 'none'; style-src ${own} 'unsafe-inline'; img-src ${own} data: blob:; `
    + `script-src ${own} 'wasm-unsafe-eval'; worker-src blob:; connect-src ${own}`;
  return `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<link rel="stylesheet" href="${place("panel.css")}">
<script type="module" src="${place("panel.js")}"></script>
</head>
<body data-wasm="${place("hedgerow.wasm")}" data-worker="${place("worker.js")}" data-bunny="${place("bunny.obj")}">
<div id="diagram" aria-live="polite"></div>
<div id="right"></div>
</body>
</html>`;
};
