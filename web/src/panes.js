// What stands below the program: its diagram, its plan, code in other languages, and the meshes that
// it breaks.

import { count, find, inline, make, picture, verdict } from './dom.js'

const PHASES = {
  collect: '1. Collect', allocate: '2. Allocate', reassign: '3. Reassign', erase: '4. Erase',
}

export class Panes {
  shown = 'diagram'
  /** Called with a counterexample, and the arrays of its mesh. */
  onCounterexample = () => {}
  #editor
  #engine
  #turn = 0

  constructor(editor, engine) {
    this.#editor = editor
    this.#engine = engine
    const tabs = [...document.querySelectorAll('[role=tab]')]
    for (const tab of tabs) {
      tab.addEventListener('click', () => this.choose(tab.dataset.pane))
      tab.addEventListener('keydown', event => {
        const at = {
          ArrowRight: tabs.indexOf(tab) + 1, ArrowLeft: tabs.indexOf(tab) - 1, Home: 0, End: -1,
        }[event.key]
        if (at === undefined) return
        event.preventDefault()
        const next = tabs.at(at % tabs.length)
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
    find('pane').scrollTop = 0
    return this.refresh()
  }

  /** The program breaks so many meshes. */
  breaks(many) {
    find('breaks').hidden = !many
    find('breaks').textContent = many
    find('breaks').title = `${count(many, 'mesh', 'meshes')} that the program breaks`
    if (this.shown === 'counterexample') this.refresh()
  }

  /** The picture that is shown, as a file. */
  get picture() {
    return find('pane').querySelector('svg')?.outerHTML
  }

  /** Shows what belongs to the cursor. */
  async refresh() {
    const turn = ++this.#turn
    const content = await this.#content().catch(error => note(String(error.message ?? error)))
    if (turn !== this.#turn || !content) return
    const pane = find('pane')
    pane.setAttribute('aria-labelledby', `tab-${this.shown}`)
    pane.replaceChildren(...[content].flat())
  }

  async #content() {
    if (this.shown === 'counterexample') return this.#counterexamples()
    const diagram = await this.#editor.diagram()
    if (!diagram) {
      return note('Put the cursor into an operation: its diagram, plan and code show here.')
    }
    if (this.shown === 'diagram') {
      const old = diagram.isCurrent ? [] : [note('The text cannot be read; this is as it was before.')]
      const title = `diagram of ${diagram.name}, before and after`
      return [picture(diagram.svg, title), ...old, verdict(diagram)]
    }
    if (!diagram.proved) return note('Only an operation that is proved has a plan and code.')
    const language = this.shown
    const { json } = await this.#engine.ask({ ask: 'code', op: diagram.name, language })
    if (json.error) return note(json.error)
    if (language === 'plan') return json.rules.map(plan)
    return make('pre', { className: 'code' }, json.text)
  }

  async #counterexamples() {
    const { json, bytes } = await this.#engine.ask({ ask: 'counterexamples' })
    if (!json.examples.length) {
      return note('No operation of this program is known to break a mesh. Where one does, the smallest '
        + 'such mesh shows here, and in 3D.')
    }
    return json.examples.map(example => {
      const [from, length] = example.range
      const show = make('button', { type: 'button', className: 'primary' }, 'Show it in 3D')
      show.addEventListener('click', () => {
        this.onCounterexample(example, bytes.slice(from, from + length))
      })
      const rule = example.rule ? `, rule ${example.rule}` : ''
      return make('section', { className: 'counterexample' },
        make('h3', {}, `${example.op}${rule}: ${example.code}`),
        make('p', {}, 'On this mesh: ', inline(example.verdict), '.'), show,
        picture(example.svg, `${example.op} on a mesh that it breaks, before and after`))
    })
  }
}

function note(text) {
  return make('p', { className: 'note' }, text)
}

function plan({ op, rule, phases }) {
  const title = rule ? `${op}, rule ${rule}` : op
  const bodies = phases.filter(({ rows }) => rows.length).map(({ phase, rows }) => {
    const head = make('tr', {}, make('th', { colSpan: 2, scope: 'rowgroup' }, PHASES[phase]))
    const lines = rows.map(([target, value, executed]) => make('tr',
      { className: executed ? '' : 'unchanged', title: executed ? '' : 'is so already: not executed' },
      make('td', {}, target), make('td', {}, value === null ? '' : `= ${value}`)))
    return make('tbody', {}, head, ...lines)
  })
  return make('table', { className: 'plan' }, make('caption', {}, title), ...bodies)
}
