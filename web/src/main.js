// The page: what stands where, and what happens on a click.

import { find, make, download } from './dom.js'
import { Editor } from './editor.js'
import { LocalEngine, WasmEngine } from './engine.js'
import { Lessons } from './lessons.js'
import { Panes } from './panes.js'
import { Scene, arraysOf } from './scene.js'
import { fragment, shared } from './share.js'
import EXAMPLES from 'examples'

const SHAPES = [
  'icosphere', 'tetrahedron', 'cube', 'octahedron', 'torus', 'triangle torus', 'grid',
  'triangle grid', 'tube',
]
const KINDS = ['vertex', 'halfedge', 'edge', 'face']

const state = {
  /** What can be called: the answer to the last program that was sound. */
  items: { ops: [], scripts: [] },
  op: null,
  script: null,
  mesh: 'icosphere',
  meshBytes: null,
  /** The mesh before the counterexample that is shown instead of it. */
  isExample: false,
}

const local = document.querySelector('meta[name=hedgerow-local]')?.content
const engine = local ? new LocalEngine(local) : await WasmEngine.load('hedgerow.wasm')
const scene = new Scene(find('view'))
const editor = new Editor(find('editor'), engine.lsp, {
  changed: text => changed(text),
  cursor: () => cursorMoved(),
  diagnostics: list => {
    const errors = list.filter(item => item.severity === 'error').length
    find('problems').textContent = errors ? `${errors} ${errors === 1 ? 'error' : 'errors'}` : ''
  },
})
const panes = new Panes(editor, engine, scene)
const lessons = new Lessons(engine, editor, lesson => {
  editor.open(`lesson_${lesson.name}.hedge`, lesson.program)
  openShape(lesson.mesh)
  panes.choose('diagram')
})

/** Asks, and says what cannot be answered. */
async function ask(question, bytes) {
  const { json, bytes: more } = await engine.ask(question, bytes)
  if (json.error) throw new Error(json.error)
  return { json, bytes: more }
}

function say(text, kind = 'note') {
  find('said').className = kind
  find('said').textContent = text
}

/** Runs what a button does, and shows what goes wrong. */
const doing = action => async (...of) => {
  try {
    await action(...of)
  } catch (error) {
    say(error.message, 'rejected')
  }
}

// The program.

async function changed(text) {
  const { json } = await engine.ask({ ask: 'program', name: editor.name, text })
  state.items = json
  fill('op', json.ops, state.op)
  fill('script', json.scripts, state.script)
  chooseOp()
  chooseScript()
  find('stale').hidden = json.sound
  panes.refresh()
  if (!json.sound && panes.shown === 'diagram') return
  showPlaces()
}

let moved
function cursorMoved() {
  clearTimeout(moved)
  moved = setTimeout(async () => {
    if (panes.shown !== 'counterexample') panes.refresh()
    const symbols = await editor.outline().catch(() => [])
    const line = editor.view.state.doc.lineAt(editor.offset).number - 1
    const here = symbols?.find(symbol => {
      const range = symbol.range ?? symbol.location.range
      return range.start.line <= line && line <= range.end.line
    })
    if (!here) return
    for (const [what, choose] of [['op', chooseOp], ['script', chooseScript]]) {
      const list = state.items[`${what}s`]
      if (list.some(item => item.name === here.name) && find(what).value !== here.name) {
        find(what).value = here.name
        choose()
        if (what === 'op') showPlaces()
      }
    }
  }, 100)
}

/** Fills a list of what can be called, own items first. */
function fill(what, items, wanted) {
  const list = find(what)
  const groups = [['this program', true], ['what it uses', false]].map(([label, own]) => {
    const names = items.filter(item => item.own === own).map(item => item.name)
    return names.length ? make('optgroup', { label }, ...names.map(name => new Option(name))) : ''
  })
  const before = wanted?.name ?? list.value
  list.replaceChildren(...groups.filter(Boolean))
  if (items.some(item => item.name === before)) list.value = before
  list.disabled = !items.length
}

function chosen(what) {
  return state.items[`${what}s`].find(item => item.name === find(what).value) ?? null
}

function chooseOp() {
  state.op = chosen('op')
  const free = state.op?.parameters.find(([, type]) => KINDS.includes(type))
  scene.kind = free?.[1] ?? 'face'
  find('element-label').textContent = scene.kind
  fields('op-fields', state.op, free?.[0])
  find('apply').disabled = !free
}

function chooseScript() {
  state.script = chosen('script')
  fields('script-fields', state.script)
  find('run').disabled = !state.script
  find('script-docs').textContent = (state.script?.docs.split('\n\n')[0] ?? '').replaceAll('`', '')
}

/** A field for each parameter but one. */
function fields(id, item, without) {
  const parameters = item?.parameters.filter(([name]) => name !== without) ?? []
  const known = Object.fromEntries(
    [...find(id).querySelectorAll('input')].map(input => [input.name, input.value]))
  find(id).replaceChildren(...parameters.map(([name, type, standard]) => make('label', {},
    `${name} `, make('input', {
      name, value: known[name] ?? '', placeholder: standard ?? type, size: 8,
      title: `${name}: ${type}`,
    }))))
}

/** The values of the fields that are filled. */
function given(id, item) {
  const values = {}
  for (const input of find(id).querySelectorAll('input')) {
    const text = input.value.trim()
    if (!text) continue
    const type = item.parameters.find(([name]) => name === input.name)?.[1]
    values[input.name] = value(text, type)
  }
  return values
}

function value(text, type) {
  if (type === 'bool') return text === 'true'
  if (type === 'text') return text
  const numbers = text.split(/[\s,]+/).map(part => {
    const [over, under] = part.split('/').map(Number)
    return under === undefined ? over : over / under
  })
  return type?.startsWith('vec') ? numbers : numbers[0]
}

// The mesh.

async function refresh({ frame = false } = {}) {
  const attribute = find('attribute').value || null
  const { json, bytes } = await ask({ ask: 'view', attribute })
  state.isExample = false
  scene.show({ json, arrays: arraysOf(json, bytes) })
  if (frame) scene.frame()
  tellCounts(json.counts)
  scene.renderer.domElement.setAttribute('aria-label', `the mesh: ${find('counts').textContent}`)
  const before = find('attribute').value
  find('attribute').replaceChildren(new Option('no attribute', ''),
    ...json.attributes.map(name => new Option(name)))
  if (json.attributes.includes(before)) find('attribute').value = before
  find('legend').hidden = !json.valuesOf || !scene.range
  if (scene.range) {
    find('least').textContent = scene.range[0].toPrecision(4)
    find('most').textContent = scene.range[1].toPrecision(4)
  }
  await showPlaces()
}

function tellCounts(counts) {
  const words = [['vertices', 'vertex'], ['edges', 'edge'], ['faces', 'face'], ['holes', 'hole']]
  const told = words.filter(([many]) => counts[many] || many !== 'holes')
    .map(([many, one]) => `${counts[many]} ${counts[many] === 1 ? one : many}`)
  find('counts').textContent = told.join(', ')
}

async function showPlaces() {
  if (state.isExample) return
  const isWanted = find('places').checked && state.op && !find('apply').disabled
  if (!isWanted) {
    scene.clearMarks()
    find('where').textContent = ''
    return
  }
  const { json, bytes } = await engine.ask(
    { ask: 'places', op: state.op.name, given: given('op-fields', state.op) })
  if (json.error) {
    scene.clearMarks()
    find('where').textContent = json.error.split('\n')[0].replace(/^error\[[\w-]+\]: /, '')
    return
  }
  scene.markPlaces(json.kind, bytes)
  find('where').textContent = `applies at ${json.applies} of ${json.asked} places`
}

async function point(element) {
  if (!element || !state.op || state.isExample) return scene.clearNames()
  find('element').value = element.index
  const { json } = await engine.ask(
    { ask: 'names', op: state.op.name, element, given: given('op-fields', state.op) })
  if (json.error) return say(json.error, 'rejected')
  if (json.refused) {
    scene.showNames([['', json.at, 'erased']])
    say(`${state.op.name} refuses at ${element.kind} ${element.index}: ${json.refused}`, 'rejected')
  } else {
    scene.showNames(json.names)
    const rule = json.rule ? `, rule ${json.rule}` : ''
    say(`${state.op.name} applies at ${element.kind} ${element.index}${rule}`, 'proved')
  }
}

async function apply(element) {
  if (!element || !state.op) return
  const { json } = await ask(
    { ask: 'apply', op: state.op.name, element, given: given('op-fields', state.op) })
  if (json.refused) {
    return say(`${state.op.name} refuses at ${element.kind} ${element.index}: ${json.refused}`,
      'rejected')
  }
  done(json)
  scrubber(null)
  await refresh()
  const made = json.created.length ? `, ${json.created.length} elements are new` : ''
  say(`${state.op.name} applied at ${element.kind} ${element.index}${made}`, 'proved')
}

function done({ past: [before, after] }) {
  find('undo').disabled = !before
  find('redo').disabled = !after
}

async function travel(way) {
  const { json } = await ask({ ask: way })
  done(json)
  scrubber(null)
  await refresh()
}

async function openShape(name) {
  state.mesh = name
  state.meshBytes = null
  if (name === 'bunny') {
    const response = await fetch('bunny.obj')
    return openFile('bunny.obj', new Uint8Array(await response.arrayBuffer()))
  }
  const { json } = await ask({ ask: 'shape', name })
  find('shape').value = name
  done(json)
  scrubber(null)
  await refresh({ frame: true })
  say('')
}

async function openFile(name, bytes, repair = false) {
  const { json } = await engine.ask({ ask: 'mesh', name, repair }, bytes)
  if (json.error) {
    say(json.error, 'rejected')
    if (json.mendable) {
      const mend = make('button', { type: 'button' }, 'Repair and open')
      mend.addEventListener('click', doing(() => openFile(name, bytes, true)))
      find('said').append(' ', mend)
    }
    return
  }
  Object.assign(state, { mesh: name, meshBytes: bytes })
  done(json)
  scrubber(null)
  await refresh({ frame: true })
  say(json.repaired?.length ? `repaired: ${json.repaired.join(', ')}` : `${name} is open`)
}

// Scripts.

async function run() {
  const { script } = state
  if (!script) return
  find('stop').hidden = false
  find('run').disabled = true
  say(`${script.name} is running`)
  const started = performance.now()
  try {
    const { json } = await ask(
      { ask: 'run', script: script.name, given: given('script-fields', script) })
    const seconds = (performance.now() - started) / 1000
    done(json)
    await refresh()
    scrubber(json)
    if (!json.failed) say(`${script.name}: ${seconds.toFixed(2)} seconds`, 'proved')
  } finally {
    find('stop').hidden = true
    find('run').disabled = !state.script
    find('progress').hidden = true
  }
}

/** What a run has printed and counted, and a slider through its applications. */
function scrubber(ran) {
  find('scrub').hidden = !ran?.total
  const report = find('report')
  report.replaceChildren()
  if (!ran) return
  if (ran.total) {
    find('step').max = ran.total
    find('step').value = ran.at
    find('step-count').textContent = `${ran.at} of ${ran.total}`
  }
  const lines = ran.printed.slice(-200).join('\n')
  if (lines) report.append(make('pre', {}, lines))
  if (ran.ops?.length) {
    const rows = ran.ops.map(({ op, applied, refused }) => {
      const times = refused.reduce((sum, [, count]) => sum + count, 0)
      const why = refused.map(([reason, count]) => `${count} × ${reason}`).join('; ')
      return make('tr', {}, make('td', {}, op), make('td', {}, `${applied}`),
        make('td', { title: why }, `${times}`))
    })
    const head = ['operation', 'applied', 'refused'].map(word => make('th', { scope: 'col' }, word))
    report.append(make('table', {}, make('tr', {}, ...head), ...rows))
  }
  if (ran.failed) report.append(make('pre', { className: 'rejected' }, ran.failed))
}

let seeking = false
let wanted = null
async function seek(to) {
  wanted = to
  if (seeking) return
  seeking = true
  try {
    while (wanted !== null) {
      const next = wanted
      wanted = null
      const { json } = await ask({ ask: 'seek', to: next })
      find('step-count').textContent = `${json.at} of ${json.total}`
      await refresh()
    }
  } finally {
    seeking = false
  }
}

// What is around.

function showExample(example, bytes) {
  const arrays = arraysOf(example.view, bytes)
  state.isExample = true
  scene.show({ json: example.view, arrays })
  scene.frame()
  tellCounts(example.view.counts)
  // The names of which the verdict speaks: there the mesh is broken.
  const broken = new Set([...example.verdict.matchAll(/`([^`.]+)[^`]*`/g)].map(([, name]) => name))
  scene.showNames(example.names.map(([name, element]) =>
    [name, element, broken.has(name) ? 'erased' : 'kept']))
  say(`${example.op}, carried out on this mesh: ${example.verdict}`, 'rejected')
}

async function share() {
  const name = editor.name
  const part = await fragment({ name: name.split('/').at(-1), text: editor.text, mesh: state.meshBytes ? '' : state.mesh })
  history.replaceState(null, '', part)
  try {
    await navigator.clipboard.writeText(location.href)
    say('the address is in the clipboard: it holds the whole program', 'proved')
  } catch {
    say('the address of this page holds the whole program now', 'proved')
  }
}

async function chooseProgram(choice) {
  const [sort, name] = [choice.slice(0, choice.indexOf(':')), choice.slice(choice.indexOf(':') + 1)]
  if (sort === 'lesson') return lessons.start(name)
  lessons.close()
  editor.open(name.split('/').at(-1), programs[choice])
  panes.choose('diagram')
}

const programs = {}
async function listPrograms() {
  const { json } = await ask({ ask: 'library' })
  for (const [name, text] of Object.entries(EXAMPLES)) programs[`example:${name}`] = text
  for (const [name, text] of json.files) programs[`library:${name}`] = text
  const group = (label, keys, title = key => key.slice(key.indexOf(':') + 1)) =>
    make('optgroup', { label }, ...keys.map(key => new Option(title(key), key)))
  const keys = Object.keys(programs)
  const titles = Object.fromEntries(lessons.list.map((lesson, at) =>
    [`lesson:${lesson.name}`, `${at + 1}. ${lesson.title}`]))
  find('program').append(
    group('lessons', Object.keys(titles), key => titles[key]),
    group('examples', keys.filter(key => key.startsWith('example:'))),
    group('library', keys.filter(key => key.startsWith('library:'))),
  )
}

function wire() {
  const on = (id, event, action) => find(id).addEventListener(event, doing(action))
  on('program', 'change', () => chooseProgram(find('program').value))
  on('share', 'click', share)
  on('op', 'change', () => (chooseOp(), showPlaces()))
  on('op-fields', 'change', showPlaces)
  on('places', 'change', showPlaces)
  on('script', 'change', chooseScript)
  on('run', 'click', run)
  on('stop', 'click', () => engine.stop())
  on('undo', 'click', () => travel('undo'))
  on('redo', 'click', () => travel('redo'))
  on('frame', 'click', () => scene.frame())
  on('attribute', 'change', () => refresh())
  on('shape', 'change', () => openShape(find('shape').value))
  on('apply', 'click', () => apply({ kind: scene.kind, index: Number(find('element').value) }))
  on('element', 'input', () => point({ kind: scene.kind, index: Number(find('element').value) }))
  on('step', 'input', () => seek(Number(find('step').value)))
  on('step-back', 'click', () => stepBy(-1))
  on('step-on', 'click', () => stepBy(1))
  on('file', 'change', async () => {
    const [file] = find('file').files
    if (file) await openFile(file.name, new Uint8Array(await file.arrayBuffer()))
    find('file').value = ''
  })
  on('save', 'change', async () => {
    const ending = find('save').value
    find('save').value = ''
    if (ending === 'svg') {
      if (!panes.picture) throw new Error('put the cursor into an operation first')
      return download(`${state.op?.name ?? 'diagram'}.svg`, panes.picture, 'image/svg+xml')
    }
    if (ending === 'back') {
      const { json } = await engine.save(editor.text)
      if (json.error) throw new Error(json.error)
      return say(`saved: ${json.saved}`, 'proved')
    }
    if (ending === 'hedge') return download(editor.name, editor.text, 'text/plain')
    const stem = state.mesh.split('/').at(-1).split('.')[0].replaceAll(' ', '_')
    const name = `${stem}.${ending}`
    const { bytes } = await ask({ ask: 'save', name })
    download(name, bytes)
  })
  scene.onClick = doing(async element => {
    if (state.isExample) return
    find('element').value = element?.index ?? find('element').value
    await apply(element)
  })
  scene.onPoint = doing(point)
  panes.onCounterexample = showExample
  engine.onProgress = (done, total) => {
    find('progress').hidden = false
    if (total) Object.assign(find('progress'), { max: total, value: done })
    else find('progress').removeAttribute('value')
  }
  engine.onRestart = async () => {
    await engine.ask({ ask: 'program', name: editor.name, text: editor.text })
    if (state.meshBytes) await engine.ask({ ask: 'mesh', name: state.mesh, repair: true }, state.meshBytes)
    else await openShape(state.mesh)
    await refresh()
    say('stopped: the mesh is as it was opened')
  }
  document.addEventListener('dragover', event => event.preventDefault())
  document.addEventListener('drop', doing(async event => {
    event.preventDefault()
    const [file] = event.dataTransfer.files
    if (!file) return
    if (file.name.endsWith('.hedge')) {
      lessons.close()
      editor.open(file.name, await file.text())
    } else {
      await openFile(file.name, new Uint8Array(await file.arrayBuffer()))
    }
  }))
}

async function stepBy(by) {
  const slider = find('step')
  slider.value = Number(slider.value) + by
  await seek(Number(slider.value))
}

async function begin() {
  find('shape').append(...SHAPES.map(name => new Option(name)), new Option('bunny'))
  wire()
  await lessons.load()
  await listPrograms()
  const given = await shared(location.hash)
  const started = local ? await engine.start() : null
  if (started?.json.error) say(started.json.error, 'rejected')
  if (started?.json.program || started?.json.mesh) {
    const { program, text, mesh } = started.json
    if (program) editor.open(program, text)
    else await chooseProgram('example:flip.hedge')
    if (mesh) await openFile(mesh, started.bytes)
    else await openShape('icosphere')
    find('save-program').hidden = !program
  } else if (given) {
    editor.open(given.name, given.text)
    await openShape(SHAPES.includes(given.mesh) ? given.mesh : 'icosphere')
  } else {
    await openShape('icosphere')
    find('program').value = 'example:flip.hedge'
    await chooseProgram('example:flip.hedge')
  }
  document.body.dataset.ready = 'true'
}

doing(begin)()
