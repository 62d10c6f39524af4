// In real VS Code the extension colours a program, underlines what is wrong, mends it, shows the
// picture of an operation in a hover and in the panel beside the text, and formats. Pictures of
// it, and what was said, go to the folder `out`.
//
//     npm install && (cd ../vscode && npm install && npm run build)
//     node vscode.mjs                 # HEDGEROW=program, CHROMIUM=browser

import { record, workbench } from "./workbench.mjs";

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
  const codes = () => published().diagnostics.map((found) => found.code);
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

  const place = published().diagnostics.find((found) => found.code === "missing-reassignment")?.range.start;
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
  await holds("the lens says that it is proved", async () =>
    /^proved/.test(await view.locator(".codelens-decoration").first().innerText()));
  await view.waitForTimeout(1000);
  await shot("5-panel");
});
await record("conversation.jsonl");
process.exit(passed ? 0 : 1);
