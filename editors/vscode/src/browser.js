// The extension in a browser, where no program can be started: the language server comes along as
// WebAssembly; or it is behind a WebSocket, one message of the protocol in each of its messages.

const vscode = require("vscode");
const { LanguageClient } = require("vscode-languageclient/browser");
const { start, options, settings } = require("./extension");

/** What vscode-languageclient takes for a worker: something to post messages to. */
class Socket {
  constructor(address) {
    this.waiting = [];
    this.socket = new WebSocket(address);
    this.socket.onopen = () => {
      for (const message of this.waiting.splice(0)) this.postMessage(message);
    };
    this.socket.onmessage = (event) => this.onmessage?.({ data: JSON.parse(event.data) });
    this.socket.onerror = (event) => this.onerror?.(event);
  }

  postMessage(message) {
    if (this.socket.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(message));
    else this.waiting.push(message);
  }

  addEventListener(name, listener) {
    this[`on${name}`] = listener;
  }

  terminate() {
    this.socket.close();
  }
}

/** The server that comes along, in a worker. Its module is read here, wherever the extension lies. */
async function bundled(context) {
  const place = (name) => vscode.Uri.joinPath(context.extensionUri, "dist", name);
  const worker = new Worker(place("server-browser.js").toString(true));
  worker.postMessage({ module: await vscode.workspace.fs.readFile(place("hedgerow.wasm")) });
  return worker;
}

exports.activate = (context) => {
  const address = () => settings().get("bridge");
  const client = async () => {
    const server = address() ? new Socket(address()) : await bundled(context);
    return new LanguageClient("hedgerow", "hedgerow", options(), server);
  };
  const isBundled = () => !address();
  return start(context, { client, isBundled, answers: async () => true, commands: {} });
};
exports.deactivate = require("./extension").stop;
