// What stands below the program: its diagram, its plan, code in other languages, and the meshes that
// it breaks.

import { find, make } from './dom.js'

const PHASES = {
  collect: '1. Collect', allocate: '2. Allocate', reassign: '3. Reassign', erase: '4. Erase',
}

export class Panes {
  shown = 'diagram'
  #editor
  #engine
  #scene
  #op = null
  #busy = 0

  constructor(editor, engine, scene) {
    Object.assign(this, { onCounterexample: () => {} })
    this.#editor = editor
    this.#engine = engine
    this.#scene = scene
    const tabs = [...document.querySelectorAll('[role=tab]')]
    for (const tab of tabs) {
      tab.addEventListener('click', () => this.choose(tab.dataset.pane))
      tab.addEventListener('keydown', event => {
        const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key]
        if (!by) return
        const next = tabs[(tabs.indexOf(tab) + by + tabs.length) % tabs.length]
        next.focus()
        next.click()
      })
    }
  }

  choose(pane) {
    this.shown = pane
    for (const tab of document.querySelectorAll('[role=tab]')) {
      const chosen = tab.dataset.pane === pane
      tab.setAttribute('aria-selected', chosen)
      tab.tabIndex = chosen ? 0 : -1
    }
    return this.refresh()
  }

  /** The picture that is shown, as a file. */
  get picture() {
    return find('pane').querySelector('svg')?.outerHTML
  }

  /** Shows what belongs to the cursor. */
  async refresh() {
    const turn = ++this.#busy
    const content = await this.#content().catch(error => note(String(error.message ?? error)))
    if (turn !== this.#busy || !content) return
    const pane = find('pane')
    pane.setAttribute('aria-labelledby', `tab-${this.shown}`)
    pane.replaceChildren(...[content].flat())
  }

  async #content() {
    if (this.shown === 'counterexample') return this.#counterexamples()
    const diagram = await this.#editor.diagram()
    this.#op = diagram?.name ?? null
    find('verdict').textContent = ''
    if (!diagram) {
      return note('Put the cursor into an operation: its diagram, plan and code show here.')
    }
    if (this.shown === 'diagram') {
      const picture = svg(diagram.svg)
      const verdict = make('p', { className: diagram.proved ? 'proved' : 'rejected' })
      verdict.textContent = plain(diagram.verdict)
      return [picture, verdict]
    }
    if (!diagram.proved) return note('Only an operation that is proved has a plan and code.')
    const language = this.shown
    const { json } = await this.#engine.ask({ ask: 'code', op: diagram.name, language })
    if (json.error) return note(json.error)
    if (language === 'plan') return json.rules.map(plan)
    return make('pre', { className: 'code', tabIndex: 0 }, json.text)
  }

  async #counterexamples() {
    const { json, bytes } = await this.#engine.ask({ ask: 'counterexamples' })
    if (!json.examples.length) {
      return note('No operation of this program is known to break a mesh.')
    }
    return json.examples.map(example => {
      const [from, length] = example.range
      const show = make('button', { type: 'button' }, 'Show the mesh in 3D')
      show.addEventListener('click', () => {
        this.onCounterexample(example, bytes.slice(from, from + length))
      })
      const rule = example.rule ? `, rule ${example.rule}` : ''
      return make('section', { className: 'counterexample' },
        make('h3', {}, `${example.op}${rule}: ${example.code}`),
        make('p', {}, example.verdict), show, svg(example.svg))
    })
  }
}

/** A picture of the server's own making. It is shown as an image, so nothing in it is run. */
function svg(text) {
  const holder = make('div', { className: 'picture' })
  const parsed = new DOMParser().parseFromString(text, 'image/svg+xml').documentElement
  if (parsed.nodeName === 'svg') holder.append(document.importNode(parsed, true))
  return holder
}

function note(text) {
  return make('p', { className: 'note' }, text)
}

/** Markdown without its marks. */
function plain(markdown) {
  return markdown.replace(/[`*\\]/g, '')
}

function plan({ op, rule, phases }) {
  const title = rule ? `${op}, rule ${rule}` : op
  const bodies = phases.filter(({ rows }) => rows.length).map(({ phase, rows }) => {
    const head = make('tr', {}, make('th', { colSpan: 2, scope: 'rowgroup' }, PHASES[phase]))
    const lines = rows.map(([target, value, executed]) => make('tr',
      { className: executed ? '' : 'unchanged' },
      make('td', {}, target), make('td', {}, value === null ? '' : `= ${value}`)))
    return make('tbody', {}, head, ...lines)
  })
  return make('table', { className: 'plan' }, make('caption', {}, title), ...bodies)
}
