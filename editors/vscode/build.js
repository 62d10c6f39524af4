// Bundles the extension, once for the desktop and once for the browser, and takes the grammar, the
// licences and the server as WebAssembly (built in `web/wasm`) from where they are kept.

const esbuild = require("esbuild");
const fs = require("fs");

const shared = { bundle: true, external: ["vscode"], format: "cjs", minify: true, logLevel: "info" };

fs.mkdirSync("dist", { recursive: true });
fs.copyFileSync("../../grammar/hedgerow.tmLanguage.json", "dist/hedgerow.tmLanguage.json");
for (const name of ["LICENSE-APACHE", "LICENSE-MIT"]) fs.copyFileSync(`../../${name}`, `dist/${name}`);
const module = "../../web/wasm/target/wasm32-unknown-unknown/release/hedgerow_web.wasm";
if (fs.existsSync(module)) fs.copyFileSync(module, "dist/hedgerow.wasm");
else console.warn("without the bundled server: build web/wasm first");
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
