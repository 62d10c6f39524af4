// The panel of the VS Code extension: the diagram of the operation at the cursor, and the bench. What
// is shown comes from the extension, in messages.

import { Bench } from './bench.js'
import { find, make, picture, verdict } from './dom.js'
import { WasmEngine } from './engine.js'

/* global acquireVsCodeApi */
const extension = acquireVsCodeApi()
const { wasm, worker, bunny } = document.body.dataset
let bench

/** The workbench in a worker: from a text, since the panel is a page of another address. */
async function open() {
  const [module, code] = await Promise.all([
    fetch(wasm).then(answer => answer.arrayBuffer()).then(bytes => WebAssembly.compile(bytes)),
    fetch(worker).then(answer => answer.text()),
  ])
  const address = URL.createObjectURL(new Blob([code], { type: 'text/javascript' }))
  const engine = new WasmEngine(module, () => new Worker(address, { type: 'module' }), false)
  bench = new Bench(find('right'), engine, { bunny })
  bench.listMeshes()
  bench.onRestart = async () => known && bench.program(known.name, known.text, known.files)
  await bench.openShape('icosphere')
}

let known
const shown = {
  diagram(diagram) {
    const old = diagram.isCurrent ? [] : [make('p', { className: 'note' }, 'as it was when it could last be read')]
    find('diagram').replaceChildren(
      picture(diagram.svg, `diagram of ${diagram.name}`), ...old, verdict(diagram))
    bench?.choose(diagram.name)
  },
  async program(program) {
    known = program
    await bench?.program(program.name, program.text, program.files)
  },
  note(text) {
    find('diagram').replaceChildren(make('p', { className: 'note' }, text))
  },
}

// One after the other: a program has to be read before its operation is chosen.
let last = Promise.resolve()
addEventListener('message', ({ data }) => {
  for (const [what, content] of Object.entries(data)) {
    last = last.then(() => shown[what]?.(content)).catch(error => bench?.say(String(error), 'rejected'))
  }
})
if (wasm) await open().catch(error => shown.note(`The mesh cannot be shown: ${error.message}`))
else find('right').remove()
extension.postMessage('ready')
