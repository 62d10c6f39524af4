// The VS Code extension in a browser: its bundled server is given the programs of the workspace, and
// each that changes. What is tested is the extension's own code and the server as WebAssembly, in a
// worker, with a workspace that answers as VS Code does. `node --test test/files.js`.

import assert from 'node:assert/strict'
import Module, { createRequire } from 'node:module'
import { dirname, join } from 'node:path'
import { test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { Worker } from 'node:worker_threads'

const here = dirname(fileURLToPath(import.meta.url))
const extension = join(here, '../../editors/vscode/src')

/** A workspace of files that are only told of: as one of vscode.dev. */
class Workspace {
  files = new Map()
  textDocuments = []
  watchers = []
  fs = {
    readFile: async uri => {
      if (!this.files.has(uri.toString())) throw new Error(`no such file: ${uri}`)
      return new TextEncoder().encode(this.files.get(uri.toString()))
    },
  }

  uri = name => ({ toString: () => `vscode-vfs://github/a/b/${name}` })

  findFiles = async () => [...this.files.keys()].map(key => ({ toString: () => key }))

  createFileSystemWatcher = () => {
    const watcher = { heard: {}, dispose: () => (watcher.isGone = true) }
    for (const what of ['onDidCreate', 'onDidChange', 'onDidDelete']) {
      watcher[what] = hear => (watcher.heard[what] = hear)
    }
    this.watchers.push(watcher)
    return watcher
  }

  /** A file is written, or deleted if there is no text. */
  change(name, text) {
    const uri = this.uri(name)
    const what = text === undefined ? 'onDidDelete' : this.files.has(`${uri}`) ? 'onDidChange' : 'onDidCreate'
    if (text === undefined) this.files.delete(`${uri}`)
    else this.files.set(`${uri}`, text)
    this.watchers.forEach(watcher => watcher.heard[what](uri))
  }
}

test('the bundled server finds what a program uses in the workspace, and sees it change', async () => {
  const workspace = new Workspace()
  const load = Module._load
  Module._load = (name, ...of) => name === 'vscode' ? { workspace } : load(name, ...of)
  const { give } = createRequire(import.meta.url)(join(extension, 'files.js'))
  Module._load = load

  const worker = new Worker(join(extension, 'server.js'))
  try {
    worker.postMessage({ module: join(here, '../dist/hedgerow.wasm') })
    const main = `${workspace.uri('main.hedge')}`
    const diagnostics = []
    let wake = () => {}
    worker.on('message', ({ method, params }) => {
      if (method !== 'textDocument/publishDiagnostics' || params.uri !== main) return
      diagnostics.push(params.diagnostics.map(({ message }) => message).join('\n'))
      wake()
    })
    const told = async pattern => {
      const until = Date.now() + 30_000
      while (!diagnostics.length || !pattern.test(diagnostics.at(-1))) {
        assert.ok(Date.now() < until, `told: ${JSON.stringify(diagnostics)}`)
        await new Promise(heard => {
          wake = heard
          setTimeout(heard, 500)
        })
      }
    }
    let stopped
    const client = {
      sendNotification: async (method, params) => worker.postMessage({ jsonrpc: '2.0', method, params }),
      onDidChangeState: hear => ((stopped = hear), { dispose() {} }),
    }
    worker.postMessage({ jsonrpc: '2.0', id: 1, method: 'initialize', params: { capabilities: {}, processId: null, rootUri: null } })
    await client.sendNotification('initialized', {})
    const text = 'use "part.hedge"\nscript go() { part() }\n'
    await client.sendNotification('textDocument/didOpen', {
      textDocument: { uri: main, languageId: 'hedgerow', version: 1, text },
    })
    await told(/part\.hedge/)
    workspace.files.set(`${workspace.uri('part.hedge')}`, 'script part() { }\n')
    await give(client)
    await told(/^$/)
    workspace.change('part.hedge', 'script other() { }\n')
    await told(/`part`/)
    workspace.change('part.hedge', 'script part() { }\n')
    await told(/^$/)
    workspace.change('part.hedge')
    await told(/part\.hedge/)
    workspace.change('part.hedge', 'script part() { }\n')
    await told(/^$/)
    stopped({ newState: 1 })
    assert.ok(workspace.watchers.every(watcher => watcher.isGone))
  } finally {
    await worker.terminate()
  }
})
