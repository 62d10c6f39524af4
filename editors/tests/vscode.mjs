// In real VS Code the extension colours a program, underlines what is wrong, mends it, shows the
// picture of an operation in a hover and in the panel beside the text, and formats. Pictures of
// it, and what was said, go to the folder `out`.
//
//     ../../web/make && npm install && (cd ../vscode && npm install && npm run build)
//     node vscode.mjs                 # HEDGEROW=program, CHROMIUM=browser
//     node vscode.mjs --bundled       # with the server that comes along, as where nothing is installed

import { isBundled, record, workbench } from "./workbench.mjs";

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

const passed = await workbench({ width: 1280, height: 800 }, async (drive) => {
  const { view, published, shot, command, holds, text, go } = drive;
  await view.keyboard.insertText(broken);

  await holds("the missing statement is underlined", () => view.locator(".squiggly-error").count());
  await command("Problems: Focus on Problems View");
  const problems = () => view.locator(".markers-panel").innerText();
  await holds("the diagnostic has its code", async () => (await problems()).includes("missing-reassignment"));
  await shot("0-problems");
  await command("View: Toggle Panel Visibility");
  await command("View: Focus Active Editor Group");
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

  // The first name of `before` whose twin nobody sets.
  await go(8, 14);
  await view.keyboard.press("Control+.");
  await view.waitForSelector(".action-widget .monaco-list-row:visible");
  await shot("3-fixes");
  await view.keyboard.press("Enter");
  await holds("a quick fix is applied", async () => /edge eg: c \| g'/.test((await text()).split("after")[1]));
  await holds("nothing is wrong any more", async () =>
    (isBundled || published().diagnostics.length === 0) && await view.locator(".squiggly-error").count() === 0);
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
  // Below it the bench: the mesh, and the operation of the cursor, which is done at an edge.
  const inPanel = async (selector) => {
    for (const frame of view.frames()) {
      const found = frame.locator(selector);
      if (await found.count().catch(() => 0) > 0) return found.first();
    }
    return undefined;
  };
  const says = async (selector, pattern) => pattern.test(await (await inPanel(selector))?.innerText() ?? "");
  await holds("the panel shows a mesh", () => says("#counts", /162 vertices, 480 edges, 320 faces/));
  await holds("it has the operation of the cursor", async () =>
    await (await inPanel("#op"))?.inputValue() === "flip");
  await view.waitForTimeout(1000);
  const canvas = await (await inPanel("#view canvas")).boundingBox();
  const middle = [canvas.x + canvas.width / 2 + 4, canvas.y + canvas.height / 2 + 6];
  await view.mouse.move(...middle);
  await holds("names show on the mesh", async () => Boolean(await inPanel(".label")));
  await shot("5-panel");
  await view.mouse.click(...middle);
  await holds("an edge is clicked and flips", () => says("#said", /flip applied at edge \d+/));
  await holds("the lens says that it is proved", async () =>
    /^proved/.test(await view.locator(".codelens-decoration").first().innerText()));
  await shot("6-flipped");
});
if (!isBundled) await record("conversation.jsonl");
process.exit(passed ? 0 : 1);
