// The bench: a mesh in 3D, and the operations and scripts of a program that are done to it.

import { count, find, inline, make } from './dom.js'
import { fields, given } from './fields.js'
import { Scene, arraysOf } from './scene.js'
import markup from './bench.html'

export const SHAPES = [
  'icosphere', 'tetrahedron', 'cube', 'octahedron', 'torus', 'triangle torus', 'grid',
  'triangle grid', 'tube',
]
const KINDS = ['vertex', 'halfedge', 'edge', 'face']
/** The greatest number that an element may have. */
const LAST = 2 ** 32 - 1
/** The number of refusals whose reasons are told. */
const REASONS = 3

export class Bench {
  /** What can be called: the answer to the last program that was sound. */
  items = { ops: [], scripts: [] }
  op = null
  script = null
  mesh = 'icosphere'
  /** Called when another program may break meshes: with the number of them. */
  onBreaks = () => {}
  /** Called when another mesh has been opened. */
  onMesh = () => {}
  /** Called with files that are no meshes. */
  onPrograms = async () => {}
  #engine
  /** How the mesh can be opened again. */
  #source = { name: 'icosphere' }
  /** True while a counterexample is shown instead of the mesh. */
  #isExample = false
  /** The frame in which the mesh was shown last. */
  #frame = null
  #seeking = false
  #wanted = null
  #named = { ops: [], scripts: [] }

  constructor(parent, engine, { bunny } = {}) {
    parent.innerHTML = markup
    this.#engine = engine
    this.#source.bunny = bunny
    this.bunny = bunny
    this.scene = new Scene(find('view'))
    this.#wire()
  }

  /** Runs what a button does, and shows what goes wrong. */
  doing = action => async (...of) => {
    try {
      await action(...of)
    } catch (error) {
      this.say(error.message, 'rejected')
    }
  }

  say(text, kind = 'note') {
    find('said').className = kind
    find('said').replaceChildren(inline(text))
  }

  /** Asks; what cannot be answered is an error. */
  async #ask(question, bytes) {
    const { json, bytes: more } = await this.#engine.ask(question, bytes)
    if (json.error) throw new Error(json.error)
    return { json, bytes: more }
  }

  // The program.

  /** Here is a program, and the others that it may use. */
  async program(name, text, files = {}) {
    const { json } = await this.#engine.ask({ ask: 'program', name, text, files })
    this.items = json
    this.#fill('op', json.ops)
    this.#fill('script', json.scripts)
    find('apply-bar').hidden = !json.ops.length
    find('run-bar').hidden = !json.scripts.length
    const none = !json.ops.length && !json.scripts.length
    find('nothing').hidden = !none
    find('nothing').textContent = json.sound
      ? 'The program has no operation and no script to try.'
      : 'The program has errors: nothing of it can be tried yet.'
    find('stale').hidden = json.sound || none
    this.#chooseOp()
    this.#chooseScript()
    this.onBreaks(json.breaks)
    await this.#showPlaces()
  }

  /** The cursor is in an item of this name. */
  choose(name) {
    for (const [what, choose] of [['op', () => this.#chooseOp()], ['script', () => this.#chooseScript()]]) {
      const list = this.items[`${what}s`]
      if (find(what).value === name || !list.some(item => item.name === name)) continue
      find(what).value = name
      choose()
      if (what === 'op') this.doing(() => this.#showPlaces())()
    }
  }

  /** Fills a list of what can be called, own items first. */
  #fill(what, items) {
    const list = find(what)
    const groups = [['this program', true], ['what it uses', false]].map(([label, own]) => {
      const names = items.filter(item => item.own === own).map(item => item.name)
      return names.length ? make('optgroup', { label }, ...names.map(name => new Option(name))) : ''
    })
    const before = list.value
    list.replaceChildren(...groups.filter(Boolean))
    if (items.some(item => item.name === before)) list.value = before
  }

  #chosen(what) {
    return this.items[`${what}s`].find(item => item.name === find(what).value) ?? null
  }

  #chooseOp() {
    this.op = this.#chosen('op')
    const free = this.op?.parameters.find(([, type]) => KINDS.includes(type))
    this.scene.kind = free?.[1] ?? 'face'
    find('element-label').textContent = this.scene.kind
    fields('op-fields', this.op, free?.[0])
    find('apply').disabled = !free
    this.scene.clearNames()
  }

  #chooseScript() {
    this.script = this.#chosen('script')
    fields('script-fields', this.script)
    find('run').disabled = !this.script
    find('script-docs').replaceChildren(inline(this.script?.docs.split('\n\n')[0] ?? ''))
  }

  // The mesh.

  async refresh({ frame = false } = {}) {
    const attribute = find('attribute').value || null
    const { json, bytes } = await this.#ask({ ask: 'view', attribute })
    this.#isExample = false
    this.scene.show({ json, arrays: arraysOf(json, bytes) })
    // Where a mesh has become so large, so small or so far away that it has another frame, all is new.
    const isElsewhere = String(json.frame) !== String(this.#frame)
    this.#frame = json.frame
    if (frame || isElsewhere) this.scene.frame()
    this.#tellCounts(json.counts)
    const before = find('attribute').value
    find('colour').hidden = !json.attributes.length
    find('attribute').replaceChildren(new Option('none', ''),
      ...json.attributes.map(name => new Option(name)))
    if (json.attributes.includes(before)) find('attribute').value = before
    this.#tellColours(attribute, json.legend)
    await this.#showPlaces()
  }

  #tellColours(attribute, meaning) {
    find('legend').hidden = !meaning
    if (!meaning) return
    const swatch = ([text, colour]) => {
      const square = make('i', { className: 'swatch' })
      square.style.background = `rgb(${colour})`
      return make('span', {}, square, text)
    }
    const [least, most] = meaning.range?.map(number) ?? []
    const parts = meaning.swatches?.map(swatch) ?? [
      make('span', { id: 'least' }, least), make('i', { className: 'scale' }),
      make('span', { id: 'most' }, most),
    ]
    find('legend').replaceChildren(make('b', {}, attribute), ...parts)
  }

  #tellCounts(counts) {
    const words = [['vertices', 'vertex'], ['edges', 'edge'], ['faces', 'face'], ['holes', 'hole']]
    const told = words.filter(([many]) => counts[many] || many !== 'holes')
      .map(([many, one]) => count(counts[many], one, many))
    find('counts').textContent = told.join(', ')
    this.scene.name = `the mesh: ${told.join(', ')}`
  }

  async #showPlaces() {
    if (this.#isExample) return
    find('where').textContent = ''
    if (!find('places').checked || !this.op || find('apply').disabled) return this.scene.clearMarks()
    let values
    try {
      values = given('op-fields', this.op)
    } catch (error) {
      this.scene.clearMarks()
      find('where').textContent = error.message
      return
    }
    const { json, bytes } = await this.#engine.ask(
      { ask: 'places', op: this.op.name, given: values })
    if (json.error) {
      this.scene.clearMarks()
      find('where').textContent = json.error.split('\n')[0].replace(/^error\[[\w-]+\]: /, '')
      return
    }
    this.scene.markPlaces(json.kind, bytes)
    const refused = json.reasons.map((reason, at) => [reason, bytes.filter(it => it === at + 2).length])
      .filter(([, many]) => many).sort((one, other) => other[1] - one[1])
    const reasons = refused.slice(0, REASONS).map(([reason, many]) => `${many} × ${reason}`).join('; ')
    find('where').replaceChildren(inline(`applies at ${json.applies} of ${json.asked} places`
      + (reasons ? `; refused: ${reasons}` : '')))
  }

  async #point(element) {
    if (!element || !this.op || this.#isExample) return this.scene.clearNames()
    find('element').value = element.index
    const { json } = await this.#engine.ask(
      { ask: 'names', op: this.op.name, element, given: given('op-fields', this.op) })
    if (json.error) return this.say(json.error, 'rejected')
    const place = `${element.kind} ${element.index}`
    if (json.refused) {
      this.scene.showNames([['', json.at, 'erased']])
      this.say(`${this.op.name} refuses at ${place}: ${json.refused}`, 'rejected')
    } else {
      this.scene.showNames(json.names)
      const rule = json.rule ? `, rule ${json.rule}` : ''
      this.say(`${this.op.name} applies at ${place}${rule}`, 'proved')
    }
  }

  async apply(element) {
    if (!element || !this.op) return
    const { json } = await this.#ask(
      { ask: 'apply', op: this.op.name, element, given: given('op-fields', this.op) })
    const place = `${element.kind} ${element.index}`
    if (json.refused) {
      return this.say(`${this.op.name} refuses at ${place}: ${json.refused}`, 'rejected')
    }
    this.#done(json)
    await this.refresh()
    const made = json.created.length ? `, ${count(json.created.length, 'element is', 'elements are')} new` : ''
    this.say(`${this.op.name} applied at ${place}${made}`, 'proved')
  }

  /** The mesh is another one. */
  #done({ past: [before, after] }, ran = null) {
    const held = document.activeElement
    find('undo').disabled = !before
    find('redo').disabled = !after
    // The focus does not stay on what can do nothing: the other one of both can.
    if (held === find('undo') && !before) find('redo').focus()
    if (held === find('redo') && !after) find('undo').focus()
    this.#scrubber(ran)
  }

  async #travel(way) {
    this.#done((await this.#ask({ ask: way })).json)
    await this.refresh()
    this.say('')
  }

  /** Opens a mesh that has a name. */
  async openShape(name) {
    if (name === 'bunny') {
      const response = await fetch(this.bunny)
      if (!response.ok) throw new Error(`the bunny cannot be had: ${response.statusText}`)
      await this.openFile('bunny.obj', new Uint8Array(await response.arrayBuffer()))
      find('shape').value = name
      return
    }
    const { json } = await this.#ask({ ask: 'shape', name })
    this.mesh = name
    this.#source = { name }
    this.onMesh()
    find('shape').value = name
    this.#done(json)
    await this.refresh({ frame: true })
    this.say('')
  }

  /** Opens a mesh file; without bytes, one of the folder of `hedgerow play`. */
  async openFile(name, bytes, repair = false) {
    this.say(`${name} is being read`)
    const question = { ask: 'mesh', name, repair, of_host: !bytes }
    const { json } = await this.#engine.ask(question, bytes)
    if (json.error) {
      this.say(json.error, 'rejected')
      if (json.mendable) {
        const mend = make('button', { type: 'button' }, 'Repair and open')
        mend.addEventListener('click', this.doing(() => this.openFile(name, bytes, true)))
        find('said').append(' ', mend)
      }
      return
    }
    this.mesh = name
    this.#source = { name, bytes, repair, isFile: true }
    this.onMesh()
    const key = `folder:${name}`
    find('shape').value = [...find('shape').options].some(option => option.value === key) ? key : ''
    this.#done(json)
    await this.refresh({ frame: true })
    this.say(json.repaired?.length ? `repaired: ${json.repaired.join(', ')}` : `${name} is open`)
  }

  /** The files that are chosen or dropped: meshes here, programs where they belong. */
  async openFiles(files) {
    const [programs, meshes] = [true, false].map(
      wanted => files.filter(file => /\.hedge$/i.test(file.name) === wanted))
    if (programs.length) await this.onPrograms(programs)
    const mesh = meshes.at(-1)
    if (mesh) await this.openFile(mesh.name, new Uint8Array(await mesh.arrayBuffer()))
  }

  /** The name of the mesh, if an address can hold it. */
  get shape() {
    return this.#source.isFile ? (this.mesh === 'bunny.obj' ? 'bunny' : '') : this.mesh
  }

  /** Lists meshes that can be chosen: those that have names, and files of a folder. */
  listMeshes(files = []) {
    const list = find('shape')
    const before = list.value
    const names = this.bunny ? [...SHAPES, 'bunny'] : SHAPES
    const options = names.map(name => new Option(name))
    const folder = files.map(name => new Option(name, `folder:${name}`))
    list.replaceChildren(...(files.length
      ? [make('optgroup', { label: 'folder' }, ...folder), make('optgroup', { label: 'shapes' }, ...options)]
      : options))
    list.value = before
  }

  async file(ending) {
    const stem = this.mesh.split('/').at(-1).split('.')[0].replaceAll(' ', '_')
    const name = `${stem}.${ending}`
    const { bytes } = await this.#ask({ ask: 'save', name })
    return { name, bytes }
  }

  // Scripts.

  async #run() {
    const { script } = this
    if (!script) return
    find('stop').hidden = false
    find('run').disabled = true
    this.say(`${script.name} is running`)
    this.#scrubber()
    const started = performance.now()
    try {
      const { json } = await this.#ask(
        { ask: 'run', script: script.name, given: given('script-fields', script) })
      const seconds = (performance.now() - started) / 1000
      this.#done(json, json)
      await this.refresh()
      this.scene.keepInView()
      if (json.failed) this.say(`${script.name} did not come to its end`, 'rejected')
      else this.say(`${script.name}: ${seconds.toFixed(2)} seconds`, 'proved')
    } finally {
      find('stop').hidden = true
      find('run').disabled = !this.script
      find('progress').hidden = true
    }
  }

  /** What a run has printed and counted, and a slider through its applications. */
  #scrubber(ran) {
    find('scrub').hidden = !ran?.total
    const report = find('report')
    report.replaceChildren()
    if (!ran) return
    if (ran.total) {
      Object.assign(find('step'), { max: ran.total, value: ran.at })
      find('step-count').textContent = `${ran.at} of ${ran.total}`
    }
    if (ran.failed) report.append(make('pre', { className: 'rejected' }, ran.failed))
    const lines = ran.printed.slice(-200).join('\n')
    if (lines) report.append(make('pre', {}, lines))
    if (ran.ops?.length) {
      const rows = ran.ops.map(({ op, applied, refused }) => {
        const times = refused.reduce((sum, [, many]) => sum + many, 0)
        const why = refused.map(([reason, many]) => `${many} × ${reason}`).join('; ')
        return make('tr', {}, make('th', { scope: 'row' }, op), make('td', {}, `${applied}`),
          make('td', {}, `${times}`), make('td', { className: 'note' }, inline(why)))
      })
      const head = ['operation', 'applied', 'refused', 'because']
        .map(word => make('th', { scope: 'col' }, word))
      report.append(make('table', {}, make('tr', {}, ...head), ...rows))
    }
  }

  async #seek(to) {
    this.#wanted = to
    if (this.#seeking) return
    this.#seeking = true
    try {
      while (this.#wanted !== null) {
        const next = this.#wanted
        this.#wanted = null
        const { json } = await this.#ask({ ask: 'seek', to: next })
        find('step-count').textContent = `${json.at} of ${json.total}`
        await this.refresh()
      }
    } finally {
      this.#seeking = false
      find('progress').hidden = true
    }
  }

  async #stepBy(by) {
    const slider = find('step')
    slider.value = Number(slider.value) + by
    await this.#seek(Number(slider.value))
  }

  // Counterexamples.

  /** Shows a mesh that an operation breaks, with the pointers that contradict each other. */
  showExample(example, bytes) {
    this.#isExample = true
    this.scene.show({ json: example.view, arrays: arraysOf(example.view, bytes) })
    this.scene.frame()
    this.#tellCounts(example.view.counts)
    find('legend').hidden = true
    this.scene.showNames(example.names.map(([name, element]) => [name, element, 'kept']))
    this.scene.showPointers(example.broken)
    this.say(`${example.op}, carried out on this mesh: ${example.verdict}`, 'rejected')
    const back = make('button', { type: 'button' }, 'Back to the mesh')
    back.addEventListener('click', this.doing(async () => {
      await this.refresh({ frame: true })
      this.say('')
    }))
    find('said').append(' ', back)
  }

  #wire() {
    const on = (id, event, action) => find(id).addEventListener(event, this.doing(action))
    on('op', 'change', () => (this.#chooseOp(), this.#showPlaces()))
    on('op-fields', 'change', () => this.#showPlaces())
    on('places', 'change', () => this.#showPlaces())
    on('script', 'change', () => this.#chooseScript())
    on('run', 'click', () => this.#run())
    on('stop', 'click', () => this.#engine.stop())
    on('undo', 'click', () => this.#travel('undo'))
    on('redo', 'click', () => this.#travel('redo'))
    on('frame', 'click', () => this.scene.frame())
    on('attribute', 'change', () => this.refresh())
    on('shape', 'change', () => {
      const { value } = find('shape')
      return value.startsWith('folder:') ? this.openFile(value.slice(7)) : this.openShape(value)
    })
    const typed = () => {
      const [{ kind }, { value }] = [this.scene, find('element')]
      const index = Number(value)
      if (!Number.isInteger(index) || index < 0 || index > LAST) {
        throw new Error(`${value} is not the number of any ${kind}: whole numbers from 0 on are`)
      }
      return { kind, index }
    }
    on('apply', 'click', () => {
      if (find('element').value === '') throw new Error(`which ${this.scene.kind}? Click one, or give its number`)
      return this.apply(typed())
    })
    on('element', 'input', () => find('element').value !== '' && this.#point(typed()))
    on('element', 'keydown', event => event.key === 'Enter' && find('element').value !== '' && this.apply(typed()))
    on('step', 'input', () => this.#seek(Number(find('step').value)))
    on('step-back', 'click', () => this.#stepBy(-1))
    on('step-on', 'click', () => this.#stepBy(1))
    on('file', 'change', async () => {
      await this.openFiles([...find('file').files])
      find('file').value = ''
    })
    this.scene.onClick = this.doing(async element => {
      if (this.#isExample || !element) return
      find('element').value = element.index
      await this.apply(element)
    })
    this.scene.onPoint = this.doing(element => this.#point(element))
    document.addEventListener('dragover', event => event.preventDefault())
    document.addEventListener('drop', this.doing(event => {
      event.preventDefault()
      return this.openFiles([...event.dataTransfer.files])
    }))
    this.#engine.onProgress = (done, total) => {
      if (find('stop').hidden) return
      find('progress').hidden = false
      if (total) Object.assign(find('progress'), { max: total, value: done })
      else find('progress').removeAttribute('value')
    }
    this.#engine.onRestart = async why => {
      await this.onRestart()
      const { name, bytes, repair, isFile } = this.#source
      if (isFile) await this.openFile(name, bytes, repair)
      else await this.openShape(name)
      this.say(`${why}: the mesh is as it was opened`, why === 'stopped' ? 'note' : 'rejected')
    }
  }
}

const number = value => Number.isFinite(value) ? String(Number(value.toPrecision(4))) : 'none'
