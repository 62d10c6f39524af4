// Bundles the extension, once for the desktop and once for the browser, and takes the grammar
// and the licences from where they are kept.

const esbuild = require("esbuild");
const fs = require("fs");

const shared = { bundle: true, external: ["vscode"], format: "cjs", minify: true, logLevel: "info" };

fs.mkdirSync("dist", { recursive: true });
fs.copyFileSync("../../grammar/hedgerow.tmLanguage.json", "dist/hedgerow.tmLanguage.json");
for (const name of ["LICENSE-APACHE", "LICENSE-MIT"]) fs.copyFileSync(`../../${name}`, `dist/${name}`);
Promise.all([
  esbuild.build({
    ...shared, entryPoints: ["src/desktop.js"], outfile: "dist/extension.js", platform: "node",
  }),
  esbuild.build({
    ...shared, entryPoints: ["src/browser.js"], outfile: "dist/browser.js", platform: "browser",
  }),
]).catch(() => process.exit(1));
