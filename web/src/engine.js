// What answers: a language server and a workbench, in this browser or on this machine.
//
// Both speak the same: `lsp` takes messages of the Language Server Protocol as JSON texts and hands
// its own to whoever has subscribed; `ask` takes a question and bytes, and promises an answer and
// bytes. See `src/play` and `src/lsp` of the crate.

const encoder = new TextEncoder()
const decoder = new TextDecoder()

/** A question as bytes: the length of the JSON, the JSON, the rest. */
export function pack(json, bytes = new Uint8Array(0)) {
  const text = encoder.encode(JSON.stringify(json))
  const all = new Uint8Array(4 + text.length + bytes.length)
  new DataView(all.buffer).setUint32(0, text.length, true)
  all.set(text, 4)
  all.set(bytes, 4 + text.length)
  return all
}

/** An answer from bytes. */
export function unpack(all) {
  const length = new DataView(all.buffer, all.byteOffset).getUint32(0, true)
  const json = JSON.parse(decoder.decode(all.subarray(4, 4 + length)))
  return { json, bytes: all.slice(4 + length) }
}

/** The engine in this browser: two workers with an instance each, so that a long run can be stopped. */
export class WasmEngine {
  #module
  #worker
  #server
  #runner
  #handlers = new Set()
  #waiting = new Map()
  #next = 0
  #failures = 0
  /** Called with how far a script is. */
  onProgress = () => {}
  /** Called when the workbench is an empty one again, with why. */
  onRestart = async () => {}
  /** Called when the language server is a new one, which knows no file. */
  onServerRestart = () => {}
  /** Called, with an error, when one of both answers no more. */
  onEnded = () => {}

  /** `worker` starts a worker; without a server there is a workbench only. */
  constructor(module, worker, hasServer = true) {
    this.#module = module
    this.#worker = worker
    if (hasServer) this.#serve()
    this.#runner = this.#start(message => this.#answered(message))
  }

  static async load(url) {
    const worker = () => new Worker(new URL('worker.js', import.meta.url), { type: 'module' })
    return new WasmEngine(await WebAssembly.compileStreaming(fetch(url)), worker)
  }

  #serve() {
    this.#server = this.#start(({ lsp, failed }) => {
      if (failed) return this.#failed(this.#server, 'the language server', failed)
      for (const text of lsp) this.#handlers.forEach(handler => handler(text))
    })
  }

  /** A new worker takes the place of one whose instance has failed: that answers nothing any more. */
  #failed(worker, name, why) {
    worker.terminate()
    if (++this.#failures > 3) {
      return this.onEnded(new Error(`${name} fails again and again (${why}): reload the page`))
    }
    if (worker === this.#runner) return this.stop(`${name} has failed (${why})`)
    this.#serve()
    this.onServerRestart()
  }

  #start(heard) {
    const worker = this.#worker()
    worker.onmessage = event => heard(event.data)
    worker.postMessage({ module: this.#module })
    return worker
  }

  #answered(message) {
    if (message.progress) return this.onProgress(...message.progress)
    if (message.failed) return this.#failed(this.#runner, 'the workbench', message.failed)
    this.#waiting.get(message.id)?.resolve(unpack(message.answer))
    this.#waiting.delete(message.id)
  }

  lsp = {
    send: text => this.#server.postMessage({ lsp: text }),
    subscribe: handler => this.#handlers.add(handler),
    unsubscribe: handler => this.#handlers.delete(handler),
  }

  ask(json, bytes) {
    const id = ++this.#next
    const question = pack(json, bytes)
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject })
      this.#runner.postMessage({ id, question }, [question.buffer])
    })
  }

  /** Ends what runs. The workbench is lost with its worker; who listens fills a new one. */
  async stop(why = 'stopped') {
    this.#runner.terminate()
    for (const { reject } of this.#waiting.values()) reject(new Error(why))
    this.#waiting.clear()
    this.#runner = this.#start(message => this.#answered(message))
    await this.onRestart(why)
  }
}

/** The engine behind `hedgerow play`, on this machine. */
export class LocalEngine {
  #handlers = new Set()
  #queue = Promise.resolve()
  #base
  onProgress = () => {}
  onRestart = async () => {}
  /** Called once, with an error, when messages do not arrive any more. */
  onEnded = () => {}

  constructor(base) {
    this.#base = base
  }

  async #post(path, body) {
    const response = await fetch(this.#base + path, { method: 'POST', body }).catch(() => {
      throw new Error('hedgerow play has ended; start it again, and save what is here')
    })
    if (response.status === 410) throw new Error(await response.text())
    if (!response.ok) throw new Error(`${response.status}: hedgerow play has ended`)
    return new Uint8Array(await response.arrayBuffer())
  }

  lsp = {
    send: text => {
      // One after the other: the order of messages matters.
      this.#queue = this.#queue.then(async () => {
        const answers = await this.#post('lsp', `[${text}]`)
        for (const message of JSON.parse(decoder.decode(answers))) {
          this.#handlers.forEach(handler => handler(JSON.stringify(message)))
        }
      }).catch(error => {
        this.onEnded(error)
        this.onEnded = () => {}
      })
    },
    subscribe: handler => this.#handlers.add(handler),
    unsubscribe: handler => this.#handlers.delete(handler),
  }

  async ask(json, bytes) {
    const asked = this.#post('ask', pack(json, bytes))
    if (json.ask !== 'run' && json.ask !== 'seek') return unpack(await asked)
    const timer = setInterval(async () => {
      const told = await this.#post('progress', '').then(unpack, () => null)
      if (told) this.onProgress(told.json.done, told.json.total)
    }, 200)
    try {
      return unpack(await asked)
    } finally {
      clearInterval(timer)
    }
  }

  async stop() {
    await this.#post('stop', '')
  }

  /** Says that the page is gone. */
  close() {
    navigator.sendBeacon(`${this.#base}close`)
  }

  /** The folder, the program and the mesh that `hedgerow play` was started with. */
  async start() {
    return unpack(await this.#post('start', ''))
  }

  /** The programs and meshes of the folder. */
  async files() {
    return unpack(await this.#post('files', ''))
  }

  /** A program of the folder. */
  async open(name) {
    return unpack(await this.#post('open', JSON.stringify({ name })))
  }

  /** Writes a program to the folder, where it still says `was`; null where it is new there. */
  async save(name, was, text) {
    return unpack(await this.#post('save', JSON.stringify({ name, was, text })))
  }
}
