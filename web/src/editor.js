// The editor: CodeMirror with the language server, which knows all open files.

import { autocompletion } from '@codemirror/autocomplete'
import { defaultKeymap, history, historyKeymap, indentWithTab } from '@codemirror/commands'
import { bracketMatching, foldGutter, indentUnit } from '@codemirror/language'
import { lintGutter, lintKeymap, setDiagnostics } from '@codemirror/lint'
import {
  LSPClient, findReferencesKeymap, formatKeymap, hoverTooltips, jumpToDefinitionKeymap,
  renameKeymap, serverCompletion, signatureHelp,
} from '@codemirror/lsp-client'
import { highlightSelectionMatches, searchKeymap } from '@codemirror/search'
import { EditorState, StateEffect, StateField } from '@codemirror/state'
import {
  Decoration, EditorView, drawSelection, highlightActiveLine, highlightActiveLineGutter, keymap,
  lineNumbers,
} from '@codemirror/view'
import { inline } from './dom.js'
import { Files } from './workspace.js'

const SEVERITIES = ['error', 'error', 'warning', 'info', 'hint']

/** Colours that the server tells: classes by the names of the protocol. */
const setColours = StateEffect.define()
const colours = StateField.define({
  create: () => Decoration.none,
  update(known, transaction) {
    for (const effect of transaction.effects) if (effect.is(setColours)) return effect.value
    return known.map(transaction.changes)
  },
  provide: field => EditorView.decorations.from(field),
})

export class Editor {
  #client
  #timer
  #events
  view

  /**
   * `events.changed()` is called a moment after typing, `events.cursor()` when the cursor has moved,
   * `events.diagnostics(list)` when the server has said what is wrong, `events.files()` when other
   * files are open.
   */
  constructor(parent, transport, events) {
    this.#events = events
    const publish = (client, { uri, diagnostics }) => {
      this.#show(uri, diagnostics)
      return true
    }
    this.#client = new LSPClient({
      timeout: 20000,
      workspace: client => new Files(client),
      notificationHandlers: { 'textDocument/publishDiagnostics': publish },
      extensions: [
        { clientCapabilities: CAPABILITIES },
        serverCompletion(), hoverTooltips({ hoverTime: 350 }), signatureHelp(),
        keymap.of([
          ...formatKeymap, ...renameKeymap, ...jumpToDefinitionKeymap, ...findReferencesKeymap,
        ]),
      ],
    })
    this.view = new EditorView({ parent })
    this.files.view = this.view
    this.files.onShown = file => this.show(file)
    this.connect(transport)
  }

  /** Tells a new server of all files. */
  connect(transport) {
    this.#client.connect(transport)
  }

  /** The open files. */
  get files() {
    return this.#client.workspace
  }

  get name() {
    return this.files.shown?.name ?? ''
  }

  /** Opens a program of a sort, see `OpenFile`, and shows it, in the place of one that gives way. */
  open(name, text, sort = {}) {
    const { shown } = this.files
    if (shown?.isPassing && !shown.isChanged) this.files.remove(shown.name)
    const file = this.files.add(name, this.#state(name, text), sort)
    this.show(file)
    // The first operation, or the first script, is what one wants to see.
    const first = /^(op|script|fn) +\w/m.exec(text)
    const at = first ? first.index + first[0].length - 1 : 0
    const effects = EditorView.scrollIntoView(at, { y: 'start', yMargin: 70 })
    this.view.dispatch({ selection: { anchor: at }, effects })
  }

  #state(name, text) {
    return EditorState.create({
      doc: text,
      extensions: [
        lineNumbers(), foldGutter(), highlightActiveLineGutter(), highlightActiveLine(), history(),
        drawSelection(), bracketMatching(), highlightSelectionMatches(), lintGutter(),
        autocompletion(), indentUnit.of('  '), colours,
        // Files are opened by the page, and not typed here as well.
        EditorView.domEventHandlers({ drop: event => event.dataTransfer?.files.length > 0 }),
        EditorView.contentAttributes.of({
          'aria-label': `program ${name}`, 'aria-describedby': 'editor-keys', tabindex: '0',
        }),
        keymap.of([
          ...lintKeymap, ...searchKeymap, ...historyKeymap, ...defaultKeymap, indentWithTab,
        ]),
        this.#client.plugin(this.files.uri(name), 'hedgerow'),
        EditorView.updateListener.of(update => {
          if (update.docChanged) this.#later()
          if (update.docChanged || update.selectionSet) this.#events.cursor()
        }),
      ],
    })
  }

  /** Shows an open file. */
  show(file) {
    this.files.show(file)
    this.#paint()
    this.#events.files()
    this.#events.diagnostics([])
    this.#events.changed()
    this.#events.cursor()
    // What the server has said of it is said again.
    if (file.told) this.#show(file.uri, file.told)
  }

  close(name) {
    const at = this.files.files.findIndex(file => file.name === name)
    const isShown = this.files.shown?.name === name
    this.files.remove(name)
    const { files } = this.files
    if (isShown && files.length) this.show(files[Math.min(at, files.length - 1)])
    else {
      this.#events.files()
      this.#events.changed()
    }
  }

  get text() {
    return this.view.state.doc.toString()
  }

  /** Replaces the whole text, which can be undone. */
  replace(text) {
    const changes = { from: 0, to: this.view.state.doc.length, insert: text }
    this.view.dispatch({ changes, userEvent: 'input' })
  }

  /** Goes to a place of the text. */
  go(offset) {
    this.view.dispatch({
      selection: { anchor: Math.min(offset, this.view.state.doc.length) }, scrollIntoView: true,
    })
    this.view.focus()
  }

  get offset() {
    return this.view.state.selection.main.head
  }

  #later() {
    clearTimeout(this.#timer)
    this.#timer = setTimeout(() => {
      this.#client.sync()
      this.#paint()
      this.#events.changed()
    }, 120)
  }

  /** Asks the server something about this document. */
  async request(method, params = {}) {
    await this.#client.initializing
    this.#client.sync()
    const textDocument = { uri: this.files.shown?.uri }
    return this.#client.request(method, { textDocument, ...params })
  }

  #position(offset) {
    const line = this.view.state.doc.lineAt(offset)
    return { line: line.number - 1, character: offset - line.from }
  }

  #place({ line, character }) {
    const { doc } = this.view.state
    if (line >= doc.lines) return doc.length
    const found = doc.line(line + 1)
    return Math.min(found.from + character, found.to)
  }

  /** The diagram of the operation at the cursor. */
  diagram() {
    return this.request('hedgerow/diagram', { position: this.#position(this.offset) })
  }

  /** The names and places of what the program declares. */
  outline() {
    return this.request('textDocument/documentSymbol')
  }

  async #show(uri, diagnostics) {
    const file = this.files.getFile(uri)
    if (!file) return
    file.told = diagnostics
    if (file !== this.files.shown) return
    const doc = this.view.state.doc
    const shown = await Promise.all(diagnostics.slice(0, 40).map(async diagnostic => {
      const { range, severity, message, code } = diagnostic
      const from = this.#place(range.start)
      const actions = await this.#fixes(diagnostic).catch(() => [])
      return {
        from, to: Math.max(from, this.#place(range.end)), severity: SEVERITIES[severity ?? 1],
        source: code, message, actions, renderMessage: () => inline(message),
      }
    }))
    // What was said of an older text is told anew soon.
    if (this.view.state.doc !== doc) return
    this.view.dispatch(setDiagnostics(this.view.state, shown))
    this.#events.diagnostics(shown)
  }

  async #fixes(diagnostic) {
    const context = { diagnostics: [diagnostic], only: ['quickfix'] }
    const actions = await this.request('textDocument/codeAction', {
      range: diagnostic.range, context,
    })
    return (actions ?? []).filter(action => action.edit).slice(0, 3).map(action => ({
      name: action.title.replaceAll('`', ''),
      apply: () => this.#apply(action.edit),
    }))
  }

  #apply(edit) {
    const lists = edit.documentChanges?.map(change => change.edits)
      ?? Object.values(edit.changes ?? {})
    const changes = lists.flat().map(({ range, newText }) => ({
      from: this.#place(range.start), to: this.#place(range.end), insert: newText,
    }))
    this.view.dispatch({ changes, userEvent: 'input.fix' })
    this.view.focus()
  }

  async #paint() {
    const { view } = this
    await this.#client.initializing
    const legend = this.#client.serverCapabilities?.semanticTokensProvider?.legend
    if (!legend) return
    const doc = view.state.doc
    const tokens = await this.request('textDocument/semanticTokens/full').catch(() => null)
    if (!tokens || view.state.doc !== doc) return
    const marks = []
    let [line, character] = [0, 0]
    for (let at = 0; at < tokens.data.length; at += 5) {
      const [down, along, length, type, modifiers] = tokens.data.slice(at, at + 5)
      character = down ? along : character + along
      line += down
      const names = legend.tokenModifiers.filter((_, bit) => modifiers & (1 << bit))
      const kinds = [legend.tokenTypes[type], ...names].map(name => `tok-${name}`)
      const from = this.#place({ line, character })
      if (length) marks.push(Decoration.mark({ class: kinds.join(' ') }).range(from, from + length))
    }
    view.dispatch({ effects: setColours.of(Decoration.set(marks, true)) })
  }
}

const CAPABILITIES = {
  textDocument: {
    publishDiagnostics: { relatedInformation: true, codeDescriptionSupport: true },
    codeAction: {
      codeActionLiteralSupport: { codeActionKind: { valueSet: ['quickfix', 'refactor.rewrite'] } },
    },
    hover: { contentFormat: ['markdown'] },
    documentSymbol: { hierarchicalDocumentSymbolSupport: true },
    semanticTokens: {
      requests: { full: true }, formats: ['relative'], tokenTypes: [], tokenModifiers: [],
    },
  },
}
