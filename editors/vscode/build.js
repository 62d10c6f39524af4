// Bundles the extension, once for the desktop and once for the browser, and takes the grammar, the
// licences, the server as WebAssembly and the page of the panel (built in `web`) from where they are.

const esbuild = require("esbuild");
const fs = require("fs");

const shared = { bundle: true, external: ["vscode"], format: "cjs", minify: true, logLevel: "info" };

fs.mkdirSync("dist", { recursive: true });
fs.copyFileSync("../../grammar/hedgerow.tmLanguage.json", "dist/hedgerow.tmLanguage.json");
for (const name of ["LICENSE-APACHE", "LICENSE-MIT"]) fs.copyFileSync(`../../${name}`, `dist/${name}`);
if (!fs.existsSync("../../web/dist/hedgerow.wasm")) {
  console.error("build the page first, whose parts come along: ../../web/make");
  process.exit(1);
}
for (const name of ["hedgerow.wasm", "bunny.obj"]) fs.copyFileSync(`../../web/dist/${name}`, `dist/${name}`);
for (const name of fs.readdirSync("../../web/dist-panel")) {
  fs.copyFileSync(`../../web/dist-panel/${name}`, `dist/${name}`);
}
const server = { ...shared, entryPoints: ["src/server.js"] };
Promise.all([
  esbuild.build({ ...server, outfile: "dist/server-node.js", platform: "node" }),
  esbuild.build({
    ...server, outfile: "dist/server-browser.js", platform: "browser",
    external: ["worker_threads", "fs"],
  }),
  esbuild.build({
    ...shared, entryPoints: ["src/desktop.js"], outfile: "dist/extension.js", platform: "node",
  }),
  esbuild.build({
    ...shared, entryPoints: ["src/browser.js"], outfile: "dist/browser.js", platform: "browser",
  }),
]).catch(() => process.exit(1));
