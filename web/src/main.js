// The page: what stands where, and what happens on a click.

import { Bench, SHAPES } from './bench.js'
import { download, find, inline, make, splitter } from './dom.js'
import { Editor } from './editor.js'
import { LocalEngine, WasmEngine } from './engine.js'
import { Lessons } from './lessons.js'
import { Panes } from './panes.js'
import { showProblems } from './problems.js'
import { earlier, fragment, kept, keep, setAside, shared } from './share.js'
import { isElsewhere } from './storage.js'
import EXAMPLES from 'examples'

const local = document.querySelector('meta[name=hedgerow-local]')?.content
const engine = local ? new LocalEngine(local) : await WasmEngine.load('hedgerow.wasm')
const bench = new Bench(find('right'), engine, { bunny: 'bunny.obj' })
/** The folder of `hedgerow play`, which all programs are beside. */
let folder = ''

const editor = new Editor(find('editor'), engine.lsp, {
  changed: () => bench.doing(changed)(),
  cursor: () => cursorMoved(),
  diagnostics: list => showProblems(list, offset => editor.go(offset)),
  files: () => listFiles(),
})
const panes = new Panes(editor, engine)
const lessons = new Lessons(engine, editor, (lesson, program) => {
  for (const { name } of [...editor.files.files]) {
    if (name.startsWith('lesson_')) editor.files.remove(name)
  }
  editor.open(lessons.file, program, { isPassing: true })
  bench.doing(() => bench.openShape(lesson.mesh))()
  panes.choose('diagram')
})

// The programs.

/** The name of a program as the workbench knows it. */
const placed = name => folder + name

async function changed() {
  // Whoever opens several programs is done with it then. What is asked below waits for a script that runs.
  await null
  keepAll()
  markChanged()
  const { files, shown } = editor.files
  if (!shown) return
  const others = files.filter(file => file !== shown).map(file => [placed(file.name), file.text])
  const { name } = shown
  await bench.program(placed(name), editor.text, Object.fromEntries(others))
  panes.refresh()
}

/** The texts of the link in the address, which are not kept until they are changed. */
let linked
const texts = (files = work().files) => JSON.stringify(files.toSorted())

/** Keeps what has been written, and says it once if that cannot be. */
function keepAll() {
  const isKept = [lessons.keep(), keepWork()].every(it => it)
  const isLost = !isKept && !local && editor.files.files.some(file => file.isChanged)
  const why = !isLost ? '' : isElsewhere
    ? 'another tab is open and keeps its programs: those here are not kept'
    : 'this browser cannot keep what is written here, since its storage is full or refused: save it'
  if (why === lost) return
  if (why || find('shared').textContent === lost) tell(why, 'rejected', true)
  lost = why
}
/** Why what has been written is not kept, as it was said. */
let lost = ''

/**
 * Keeps what is open, except for a lesson, which is kept with its like; on this machine, nothing. False if
 * it cannot be kept.
 */
function keepWork() {
  if (linked) {
    if (linked === texts()) return true
    const isOther = !local && kept() && texts(kept().files) !== linked
    if (isOther && !setAside()) return false
    history.replaceState(null, '', location.pathname + location.search)
    linked = undefined
    if (isOther) {
      listPrograms()
      tell('your earlier work is in the list of programs')
    }
  }
  const own = work(file => file.name !== lessons.file)
  return local || !own.files.length || keep(own)
}

/** Whether a mesh is one that an address can hold. */
const isNamed = mesh => [...SHAPES, 'bunny'].includes(mesh)

/** Opens what a link shares, beside what has been changed, with its mesh, or else another one. */
async function openLink(given, other) {
  given.files.toReversed().forEach(([name, text]) => editor.open(unchanged(name), text))
  linked = texts()
  const mesh = isNamed(given.mesh) ? given.mesh : other
  if (mesh) await bench.openShape(mesh)
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
    if (here) bench.choose(here.name)
  }, 100)
}

/** The open programs, one of them shown, each with a way to close it. */
function listFiles() {
  const { files, shown } = editor.files
  const parts = files.map(file => {
    const show = make('button', { type: 'button', className: 'file' },
      make('span', {}, file.name), make('i', { title: 'changed', hidden: true }, '•'))
    show.setAttribute('aria-current', file === shown)
    show.dataset.name = file.name
    show.addEventListener('click', () => editor.show(file))
    if (files.length === 1) return show
    const close = make('button', { type: 'button', className: 'close' }, '×')
    close.setAttribute('aria-label', `close ${file.name}`)
    close.addEventListener('click', () => {
      const question = `${file.name} has been changed. Close it without saving?`
      if (!file.isChanged || confirm(question)) editor.close(file.name)
    })
    return make('span', { className: 'group' }, show, close)
  })
  const add = make('button', { type: 'button', className: 'plain', title: 'A new program' }, '+')
  add.setAttribute('aria-label', 'a new program')
  add.addEventListener('click', () => newProgram())
  // What had the focus has it again: the same button, or the program in its place.
  const held = document.activeElement
  const at = [...find('files').children].findIndex(part => part.contains(held))
  find('files').replaceChildren(...parts, add)
  if (at >= 0) {
    const label = held.getAttribute('aria-label')
    const same = label && [...find('files').querySelectorAll('[aria-label]')]
      .find(button => button.getAttribute('aria-label') === label)
    const shows = find('files').querySelectorAll('.file')
    const next = same || shows[Math.min(at, shows.length - 1)]
    next?.focus()
  }
  const keys = [...find('program').options].map(option => option.value)
  const key = ['lesson', 'folder', 'example', 'library'].map(sort => `${sort}:${shown?.name}`)
  find('program').value = key.find(key => keys.includes(key) && programs[key] !== undefined)
    ?? (lessons.current ? `lesson:${lessons.current.name}` : '')
  markChanged()
}

function markChanged() {
  for (const button of find('files').querySelectorAll('.file')) {
    button.lastChild.hidden = !editor.files.named(button.dataset.name)?.isChanged
  }
}

/** A name that no open program has. */
function freeName(stem) {
  for (let at = 1; ; at++) {
    const name = at === 1 ? `${stem}.hedge` : `${stem}${at}.hedge`
    if (!editor.files.named(name)) return name
  }
}

function newProgram() {
  lessons.close()
  editor.open(freeName('mine'), '')
  editor.view.focus()
}

/** Opens a program that can be had again. Where one of its name has been changed, that stays. */
function openProgram(name, text, isSaved = false) {
  const open = editor.files.named(name)
  if (open?.isChanged && isSaved) return editor.show(open)
  editor.open(unchanged(name), text, { isSaved, isPassing: true })
}

/** A name under which no changed program is open. */
function unchanged(name) {
  return editor.files.named(name)?.isChanged ? freeName(name.replace(/\.hedge$/, '')) : name
}

const programs = {}
async function chooseProgram(choice) {
  const [sort, name] = [choice.slice(0, choice.indexOf(':')), choice.slice(choice.indexOf(':') + 1)]
  if (sort === 'lesson') return lessons.start(name)
  lessons.close()
  if (sort === 'earlier') {
    earlier()[name]?.files.toReversed().forEach(([name, text]) => editor.open(unchanged(name), text))
  } else if (sort === 'folder') {
    const { json } = await engine.open(name)
    if (json.error) throw new Error(json.error)
    openProgram(name, json.text, true)
  } else {
    openProgram(name.split('/').at(-1), programs[choice])
  }
  panes.choose('diagram')
}

async function listPrograms() {
  if (!Object.keys(programs).length) {
    const { json } = await engine.ask({ ask: 'library' })
    for (const [name, text] of Object.entries(EXAMPLES)) programs[`example:${name}`] = text
    for (const [name, text] of json.files) programs[`library:${name}`] = text
  }
  const own = local ? (await engine.files()).json : { programs: [], meshes: [] }
  for (const key of Object.keys(programs)) if (key.startsWith('folder:')) delete programs[key]
  for (const name of own.programs) programs[`folder:${name}`] = null
  bench.listMeshes(own.meshes)
  const { solved } = lessons
  const titles = Object.fromEntries(lessons.list.map((lesson, at) =>
    [`lesson:${lesson.name}`, `${at + 1}. ${lesson.title}${solved.has(lesson.name) ? ' ✓' : ''}`]))
  const before = Object.fromEntries(earlier().map(({ files, time }, at) => {
    const when = time ? ` (${new Date(time).toLocaleString([], { dateStyle: 'medium', timeStyle: 'short' })})` : ''
    return [`earlier:${at}`, files.map(([name]) => name).join(', ') + when]
  }))
  const group = (label, keys, title = key => key.slice(key.indexOf(':') + 1)) =>
    keys.length ? [make('optgroup', { label }, ...keys.map(key => new Option(title(key), key)))] : []
  const sorted = sort => Object.keys(programs).filter(key => key.startsWith(`${sort}:`))
  const none = make('option', { value: '', hidden: true }, 'of your own')
  find('program').replaceChildren(none,
    ...group('folder', sorted('folder')),
    ...group('before the link', Object.keys(before), key => before[key]),
    ...group('lessons', Object.keys(titles), key => titles[key]),
    ...group('examples', sorted('example')),
    ...group('library', sorted('library')))
  listFiles()
}

// Saving and sharing.

/** The open programs, the one that is shown first, and the mesh if it has a name. */
function work(isOf = () => true) {
  const { files, shown } = editor.files
  const all = [shown, ...files.filter(file => file !== shown)].filter(Boolean).filter(isOf)
  return { files: all.map(file => [file.name, file.text]), mesh: bench.shape }
}

/** Says something about the page for a while, or until something else is said. */
let told
function tell(text, kind = 'proved', isLasting = false) {
  find('shared').className = kind
  find('shared').replaceChildren(inline(text))
  clearTimeout(told)
  if (!isLasting) told = setTimeout(() => find('shared').replaceChildren(), 8000)
}

async function share() {
  // What has just been written is kept first: from then on it is what the address holds.
  keepAll()
  linked = texts()
  history.replaceState(null, '', await fragment(work()))
  const without = bench.shape ? '' : '; your mesh is not in it'
  try {
    await navigator.clipboard.writeText(location.href)
    tell(`the address is in the clipboard, with the whole program${without}`)
  } catch {
    tell(`the address of this page holds the whole program now${without}`)
  }
}

async function save(what) {
  if (what === 'svg') {
    if (!panes.picture) throw new Error('put the cursor into an operation first')
    return download(`${bench.op?.name ?? 'diagram'}.svg`, panes.picture, 'image/svg+xml')
  }
  if (what === 'back') return saveBack()
  if (what === 'hedge') return download(editor.name.split('/').at(-1), editor.text, 'text/plain')
  const { name, bytes } = await bench.file(what)
  download(name, bytes)
}

/** Writes the program that is shown to the folder of `hedgerow play`. */
async function saveBack() {
  const { shown } = editor.files
  const text = shown.text
  const { json } = await engine.save(shown.name, shown.isSaved ? shown.kept : null, text)
  if (json.error) throw new Error(json.error)
  Object.assign(shown, { kept: text, isSaved: true })
  tell(`saved: ${json.saved}`)
  await listPrograms()
}

// The beginning.

function wire() {
  const on = (id, event, action) => find(id).addEventListener(event, bench.doing(action))
  on('program', 'change', () => chooseProgram(find('program').value))
  on('learn', 'click', () => lessons.start(lessons.next))
  on('share', 'click', share)
  // A list that is there until one of it is taken, Escape is pressed, or something else has the focus.
  const shut = () => find('save').open = false
  on('save', 'click', async ({ target }) => {
    const button = target.closest('button')
    if (!button) return
    find('save').firstElementChild.focus()
    shut()
    await save(button.value)
  })
  on('save', 'keydown', event => {
    if (event.key !== 'Escape' || !find('save').open) return
    find('save').firstElementChild.focus()
    shut()
  })
  on('save', 'focusout', event => event.relatedTarget && !find('save').contains(event.relatedTarget) && shut())
  document.addEventListener('pointerdown', event => find('save').contains(event.target) || shut())
  // Who uses Tab is told how the editor, where it indents, is left.
  const byKeys = isSo => document.body.classList.toggle('by-keys', isSo)
  document.addEventListener('keydown', event => event.key === 'Tab' && byKeys(true), true)
  document.addEventListener('pointerdown', () => byKeys(false), true)
  splitter(find('split-main'), document.querySelector('main'), ['--left', '--right'], true)
  splitter(find('split-work'), find('work'), ['--editor', '--rest'], false)
  panes.onCounterexample = (example, bytes) => {
    bench.showExample(example, bytes)
    // On a phone the mesh is below what was read.
    document.getElementById('right').scrollIntoView({ block: 'nearest' })
  }
  bench.onBreaks = many => panes.breaks(many)
  bench.onRestart = () => changed()
  bench.onMesh = keepAll
  bench.onPrograms = async files => {
    lessons.close()
    for (const file of files) editor.open(unchanged(file.name), await file.text())
  }
  lessons.onSolved = () => listPrograms()
  window.addEventListener('pagehide', keepAll)
  window.addEventListener('hashchange', bench.doing(async () => {
    const given = await shared(location.hash)
    if (!given) return
    keepAll()
    lessons.close()
    await openLink(given)
  }))
  editor.files.onWanted = async uri => {
    const name = decodeURIComponent(uri).match(/std\/[\w.]+$/)?.[0]
    if (!name || !programs[`library:${name}`]) return false
    editor.open(name.split('/').at(-1), programs[`library:${name}`])
    return true
  }
  engine.onEnded = error => bench.say(error.message, 'rejected')
  if (local) {
    window.addEventListener('focus', bench.doing(listPrograms))
    window.addEventListener('pagehide', event => event.persisted || engine.close())
    window.addEventListener('beforeunload', event => {
      if (editor.files.files.some(file => file.isChanged)) event.preventDefault()
    })
    document.addEventListener('keydown', event => {
      if (event.key !== 's' || !(event.ctrlKey || event.metaKey)) return
      event.preventDefault()
      bench.doing(saveBack)()
    })
  } else {
    engine.onServerRestart = () => editor.connect(engine.lsp)
    // Once loaded, the page needs no network; a browser that knows no service worker has its cache.
    navigator.serviceWorker?.register('offline.js').catch(() => {})
  }
}

async function begin() {
  const started = local ? (await engine.start()).json : null
  if (started) {
    folder = `${started.folder}/`
    editor.files.base = `${started.uri}/`
    find('save-program').hidden = false
  }
  await lessons.load()
  wire()
  await listPrograms()
  let [given, damage] = [null, '']
  try {
    if (!started?.program) given = await shared(location.hash)
  } catch (error) {
    damage = error.message
  }
  const own = given || local ? null : kept()
  if (started?.program) await chooseProgram(`folder:${started.program}`)
  else if (given) await openLink(given, 'icosphere')
  else if (own) {
    // It is kept with them, already before it is open.
    if (isNamed(own.mesh)) bench.mesh = own.mesh
    for (const [name, text] of own.files.toReversed()) {
      editor.open(name, text)
      editor.files.shown.kept = programs[`example:${name}`] ?? ''
    }
    markChanged()
  }
  else await chooseProgram('example:flip.hedge')
  if (started?.mesh) await bench.openFile(started.mesh)
  else if (!given) await bench.openShape(isNamed(own?.mesh) ? own.mesh : 'icosphere')
  if (damage) bench.say(damage, 'rejected')
  document.body.dataset.ready = 'true'
}

bench.doing(begin)()
