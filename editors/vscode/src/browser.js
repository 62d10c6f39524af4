// The extension in a browser, where no program can be started: the language server is behind a
// WebSocket, one message of the protocol in each of its messages.

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

const address = () => settings().get("bridge");
const client = () => new LanguageClient("hedgerow", "hedgerow", options(), new Socket(address()));
const answers = async () => Boolean(address());

exports.activate = (context) => start(context, { client, answers, commands: {} });
exports.deactivate = require("./extension").stop;
