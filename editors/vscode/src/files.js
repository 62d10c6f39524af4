// The programs of the workspace. A server that comes along as WebAssembly reads no files: it is given
// them.

const vscode = require("vscode");

/** The most programs that are looked at. */
const MOST = 2000;

/** The text of a program: as it stands in an editor, else in its file. */
exports.read = async (uri) => {
  const open = vscode.workspace.textDocuments.find((it) => it.uri.toString() === uri.toString());
  if (open) return open.getText();
  try {
    return new TextDecoder().decode(await vscode.workspace.fs.readFile(uri));
  } catch {
    return undefined;
  }
};

/** Gives a server all programs of the workspace, and then each that changes. */
exports.give = async (client) => {
  const tell = async (uris) => {
    const files = await Promise.all(uris.map(async (uri) => {
      const bytes = await Promise.resolve(vscode.workspace.fs.readFile(uri)).catch(() => undefined);
      return { uri: uri.toString(), text: bytes && new TextDecoder().decode(bytes) };
    }));
    // A server that has gone by itself has been told of already.
    await client.sendNotification("hedgerow/files", { files }).catch(() => {});
  };
  const watcher = vscode.workspace.createFileSystemWatcher("**/*.hedge");
  for (const changed of [watcher.onDidCreate, watcher.onDidChange, watcher.onDidDelete]) {
    changed((uri) => tell([uri]));
  }
  const stop = client.onDidChangeState(({ newState }) => {
    if (newState !== 1) return;
    watcher.dispose();
    stop.dispose();
  });
  const found = await vscode.workspace.findFiles("**/*.hedge", "**/{node_modules,target}/**", MOST);
  if (found.length > 0) await tell(found);
};
