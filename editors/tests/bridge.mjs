// A WebSocket before `hedgerow lsp`: one message of the protocol in each of its messages. For
// editors in browsers, which cannot start programs.
//
//     node bridge.mjs [PORT [PROGRAM]]

import { spawn } from "node:child_process";
import { pathToFileURL } from "node:url";
import { WebSocketServer } from "ws";

/** Answers on a port of this computer; `heard` is told of every message. */
export function bridge(port, program, heard = () => {}) {
  const server = new WebSocketServer({ host: "127.0.0.1", port });
  server.on("connection", (socket) => {
    const child = spawn(program, ["lsp"], { stdio: ["pipe", "pipe", "inherit"] });
    socket.on("message", (data) => {
      heard("client", JSON.parse(data));
      child.stdin.write(`Content-Length: ${data.length}\r\n\r\n`);
      child.stdin.write(data);
    });
    let pending = Buffer.alloc(0);
    child.stdout.on("data", (data) => {
      pending = Buffer.concat([pending, data]);
      for (;;) {
        const end = pending.indexOf("\r\n\r\n");
        if (end < 0) return;
        const length = Number(/content-length: *(\d+)/i.exec(pending.subarray(0, end))[1]);
        if (pending.length < end + 4 + length) return;
        const message = pending.subarray(end + 4, end + 4 + length).toString();
        pending = pending.subarray(end + 4 + length);
        heard("server", JSON.parse(message));
        socket.send(message);
      }
    });
    child.on("exit", () => socket.close());
    child.stdin.on("error", () => socket.close());
    socket.on("close", () => child.kill());
  });
  return server;
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const [port = "7777", program = "hedgerow"] = process.argv.slice(2);
  bridge(Number(port), program);
  console.log(`hedgerow lsp answers at ws://127.0.0.1:${port}`);
}
