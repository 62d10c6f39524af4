// Puts the page together in `dist`: `node build.js`. The WebAssembly module has to be there.

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
await esbuild.build({
  entryPoints: [join(here, 'src/main.js'), join(here, 'src/worker.js'), join(here, 'src/style.css')],
  outdir: dist, bundle: true, minify: true, format: 'esm', target: 'es2022', plugins: [examples],
  legalComments: 'linked', logLevel: 'warning',
})
copyFileSync(join(here, 'src/index.html'), join(dist, 'index.html'))
copyFileSync(join(root, 'examples/meshes/bunny.obj'), join(dist, 'bunny.obj'))
if (!process.argv.includes('--without-wasm')) {
  const built = 'wasm/target/wasm32-unknown-unknown/release/hedgerow_web.wasm'
  copyFileSync(join(here, built), join(dist, 'hedgerow.wasm'))
}
