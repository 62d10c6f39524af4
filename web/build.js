// Puts the page together in `dist`: `node build.js`. The WebAssembly module has to be there.

import { createHash } from 'node:crypto'
import { copyFileSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs'
import { dirname, join } from 'node:path'
import { fileURLToPath } from 'node:url'
import * as esbuild from 'esbuild'

const here = dirname(fileURLToPath(import.meta.url))
const root = dirname(here)
const dist = join(here, 'dist')

/** The programs of `examples`, as a module. */
const examples = {
  name: 'examples',
  setup(build) {
    build.onResolve({ filter: /^examples$/ }, () => ({ path: 'examples', namespace: 'examples' }))
    build.onLoad({ filter: /.*/, namespace: 'examples' }, () => {
      const folder = join(root, 'examples')
      const names = readdirSync(folder).filter(name => name.endsWith('.hedge')).sort()
      const texts = names.map(name => [name, readFileSync(join(folder, name), 'utf8')])
      return { contents: JSON.stringify(Object.fromEntries(texts)), loader: 'json' }
    })
  },
}

rmSync(dist, { recursive: true, force: true })
mkdirSync(dist)
const shared = {
  bundle: true, minify: true, format: 'esm', target: 'es2022', plugins: [examples],
  loader: { '.html': 'text' }, legalComments: 'linked', logLevel: 'warning',
}
await esbuild.build({
  ...shared, entryPoints: ['main.js', 'worker.js', 'style.css'].map(name => join(here, 'src', name)),
  outdir: dist,
})
// What the panel of the VS Code extension takes along.
const panel = join(here, 'dist-panel')
rmSync(panel, { recursive: true, force: true })
await esbuild.build({
  ...shared, entryPoints: ['panel.js', 'panel.css', 'worker.js'].map(name => join(here, 'src', name)),
  outdir: panel, legalComments: 'none',
})
for (const name of ['index.html', 'icon.svg']) copyFileSync(join(here, 'src', name), join(dist, name))
copyFileSync(join(root, 'examples/meshes/bunny.obj'), join(dist, 'bunny.obj'))
if (!process.argv.includes('--without-wasm')) {
  const built = 'wasm/target/wasm32-unknown-unknown/release/hedgerow_web.wasm'
  copyFileSync(join(here, built), join(dist, 'hedgerow.wasm'))
}
// What keeps the page for times without a network knows its files, and changes with them.
const names = readdirSync(dist).sort()
const hash = createHash('sha256')
for (const name of names) hash.update(name).update(readFileSync(join(dist, name)))
const files = names.filter(name => !name.endsWith('.txt')).map(name => name === 'index.html' ? './' : name)
await esbuild.build({
  ...shared, entryPoints: [join(here, 'src/offline.js')], outdir: dist,
  define: { VERSION: JSON.stringify(hash.digest('hex').slice(0, 12)), FILES: JSON.stringify(files) },
})
