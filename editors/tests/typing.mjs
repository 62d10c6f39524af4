// The flip, typed from nothing into real VS Code, statement by statement: one picture of what the
// editor shows at each step, `out/typing.png`. The words above each part are what the server said.
//
//     node typing.mjs                 # HEDGEROW=program, CHROMIUM=browser

import { join } from "node:path";
import { chromium } from "playwright-core";
import { out, workbench } from "./workbench.mjs";

// What is typed at each step; where `ask` is the start of the next line, the editor is asked how it
// may go on. Then a quick fix is taken.
const steps = [
  { lines: ["op flip(e: edge) keeps triangles {"] },
  { lines: ["  before {"] },
  { lines: ["    face f0: v0 -a-> v1 -b-> v2 -c-> v0"] },
  { lines: ["    face f1: v1 -d-> v0 -g-> v3 -h-> v1"] },
  { lines: ["    edge e: a | d", "  }"] },
  { lines: ['  require not adjacent(v2, v3) else "the edge v2 v3 is already there"', "  after {"] },
  { lines: [], ask: "    " },
  { lines: ["    face f0: v3 -a-> v2 -c-> v0 -g-> v3"], ask: "    " },
  { lines: ["    face f1: v2 -d-> v3 -h-> v1 -b-> v2", "  }", "}"] },
];
const parts = [];
const lineHeight = 18;

const passed = await workbench({ width: 1290, height: 640 }, async (drive) => {
  const { view, published, command, holds, go } = drive;
  await view.locator(".monaco-editor .view-lines").first().click();
  let version = published().version ?? 1;
  let typed = 0;
  /** What the server said of the text, once it has. */
  const told = async () => {
    await holds(`step ${parts.length + 1} is told`, () => (published().version ?? 0) > version);
    version = published().version;
    await view.waitForTimeout(900);
    const errors = published().diagnostics.map((error) => error.message.split("\n")[0]);
    const [lens] = await view.locator(".codelens-decoration").allTextContents();
    return [lens?.replaceAll("\u00a0", " ").split("|")[0].trim(), errors[0]].filter(Boolean);
  };
  /** The editor down to a line; all of its width if `wide`. */
  const keep = async (said, lines, wide) => {
    const box = await view.locator(".editor-instance").first().boundingBox();
    const height = Math.min(box.height, (lines + 2) * lineHeight);
    const clip = { x: box.x, y: box.y, width: wide ? 1290 - box.x : 640, height };
    const picture = await view.screenshot({ clip });
    parts.push({ said, wide, picture: picture.toString("base64") });
  };
  let said = [];
  for (const { lines, ask } of steps) {
    if (lines.length > 0) {
      await view.keyboard.insertText(`${lines.join("\n")}\n`);
      said = await told();
    }
    typed += lines.length;
    if (!ask) {
      await keep(said, typed);
      continue;
    }
    await view.keyboard.insertText(ask);
    await view.keyboard.press("Control+Space");
    await view.waitForSelector(".suggest-widget .monaco-list-row", { timeout: 10000 });
    await view.waitForTimeout(500);
    await keep(["what comes next: first what `after` has not accounted for"], typed + 7);
    await view.keyboard.press("Escape");
    await view.keyboard.press("Shift+Home");
    await view.keyboard.press("Delete");
    await view.waitForTimeout(500);
    version = published().version;
  }
  // A statement was forgotten: the editor offers it.
  const { start } = published().diagnostics[0].range;
  await go(start.line + 1, start.character + 2);
  await view.keyboard.press("Control+.");
  await view.waitForSelector(".action-widget .monaco-list-row:visible");
  await keep(["what mends it"], typed + 1);
  await view.keyboard.press("Enter");
  said = await told();
  await command("hedgerow: Show Diagram Beside");
  const drawn = async () => {
    const inner = view.frames().map((frame) => frame.locator("svg").count().catch(() => 0));
    return (await Promise.all(inner)).some((count) => count > 0);
  };
  await holds("the panel shows the diagram", drawn);
  await view.waitForTimeout(1000);
  await keep(said, 17, true);
});

const escaped = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");
const cells = parts.map(({ said, wide, picture }, at) => `<figure${wide ? ' class="wide"' : ""}>
  <figcaption><b>${at + 1}</b> ${said.map(escaped).join(" — ")}</figcaption>
  <img src="data:image/png;base64,${picture}"></figure>`);
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox"],
});
const page = await browser.newPage({ viewport: { width: 1340, height: 800 } });
await page.setContent(`<!DOCTYPE html><style>
  body { display: grid; grid-template-columns: 1fr 1fr; gap: 10px; margin: 10px;
    font: 14px sans-serif; background: white; }
  figure { margin: 0; border: 1px solid #bbb; display: flex; flex-direction: column; }
  figcaption { padding: 6px 8px; background: #eef1f5; }
  img { width: 100%; }
  .wide { grid-column: 1 / -1; }
</style>${cells.join("")}`);
await page.screenshot({ path: join(out, "typing.png"), fullPage: true });
await browser.close();
process.exit(passed ? 0 : 1);
