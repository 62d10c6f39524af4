// The open files: their texts with their histories, one of them in the editor. The language server
// has all of them, so that one may use another.

import { LSPPlugin, Workspace } from '@codemirror/lsp-client'
import { ChangeSet } from '@codemirror/state'

/** An open file. */
class OpenFile {
  version = 0
  /** Its document as the server knows it. */
  doc
  /** The text that it was opened with, or saved with last. */
  kept
  /** True for a file of the folder of `hedgerow play`. */
  isSaved
  /** True for one that can be had again, and gives way to the next unless somebody changes it. */
  isPassing

  constructor(workspace, name, state, sort) {
    Object.assign(this, sort, {
      workspace, name, state, doc: state.doc, kept: state.doc.toString(),
      uri: workspace.uri(name), languageId: 'hedgerow',
    })
  }

  getView() {
    return this.workspace.shown === this ? this.workspace.view : null
  }

  /** Its document as it is now. */
  get now() {
    return (this.getView()?.state ?? this.state).doc
  }

  get text() {
    return this.now.toString()
  }

  get isChanged() {
    return this.text !== this.kept
  }
}

export class Files extends Workspace {
  files = []
  shown = null
  view = null
  /** The address of the folder that the files lie in. */
  base = 'hedgerow:/page/'
  /** Called with the address of a file that is to be shown, when no open file has it. */
  onWanted = async () => false

  uri(name) {
    return this.base + name.split('/').map(encodeURIComponent).join('/')
  }

  named(name) {
    return this.files.find(file => file.name === name)
  }

  /** Takes a file in; one of the same name is no longer open. */
  add(name, state, sort) {
    this.remove(name)
    const file = new OpenFile(this, name, state, sort)
    this.files.push(file)
    this.client.didOpen(file)
    return file
  }

  remove(name) {
    const file = this.named(name)
    if (!file) return
    if (this.shown === file) this.shown = null
    this.files = this.files.filter(other => other !== file)
    this.client.didClose(file.uri)
  }

  /** Puts a file into the editor, which keeps the state of the one before. */
  show(file) {
    this.client.sync()
    if (this.shown) this.shown.state = this.view.state
    this.shown = file
    this.view.setState(file.state)
  }

  syncFiles() {
    const updates = []
    for (const file of this.files) {
      const plugin = file.getView() && LSPPlugin.get(file.getView())
      const doc = file.now
      if (doc.eq(file.doc)) continue
      const changes = plugin?.unsyncedChanges
        ?? ChangeSet.of({ from: 0, to: file.doc.length, insert: doc }, file.doc.length)
      updates.push({ changes, file, prevDoc: file.doc })
      file.doc = doc
      file.version += 1
      plugin?.clear()
    }
    return updates
  }

  // The files are opened and closed above, whatever the editor shows.
  openFile() {}

  closeFile() {}

  updateFile(uri, update) {
    const file = this.getFile(uri)
    if (!file) return
    if (file.getView()) this.view.dispatch(update)
    else file.state = file.state.update(update).state
  }

  async displayFile(uri) {
    const file = this.getFile(uri)
    if (file && file !== this.shown) this.onShown(file)
    else if (!file && !await this.onWanted(uri)) return null
    return this.view
  }
}
