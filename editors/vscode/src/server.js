// The language server as WebAssembly, in a worker: what answers where no program is installed.
// The first message is the module, or the path of its file; all others are of the protocol.

const isNode = typeof process !== "undefined" && Boolean(process.versions?.node);
const port = isNode ? require("worker_threads").parentPort : self;
const listen = (heard) => isNode
  ? port.on("message", heard)
  : port.addEventListener("message", (event) => heard(event.data));

let instance;
const early = [];

async function load(place) {
  const bytes = typeof place === "string" ? await require("fs").promises.readFile(place) : place;
  const host = { progress: () => {} };
  ({ instance } = await WebAssembly.instantiate(bytes, { host }));
  early.splice(0).forEach(answer);
}

/** Hands the server a message, and its messages to the client. */
function answer(message) {
  if (!instance) return early.push(message);
  const { memory, take, lsp } = instance.exports;
  const bytes = new TextEncoder().encode(JSON.stringify([message]));
  const at = take(bytes.length);
  new Uint8Array(memory.buffer, at, bytes.length).set(bytes);
  const answers = lsp();
  const length = new DataView(memory.buffer).getUint32(answers, true);
  const text = new TextDecoder().decode(new Uint8Array(memory.buffer, answers + 4, length).slice());
  for (const told of JSON.parse(text)) port.postMessage({ jsonrpc: "2.0", ...told });
}

listen((message) => {
  if (message.module) load(message.module);
  else answer(message);
});
