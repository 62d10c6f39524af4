// One instance of the WebAssembly module: answers for the language server or the workbench.

let instance
const early = []

function call(bytes, name) {
  const { memory, take } = instance.exports
  const at = take(bytes.length)
  new Uint8Array(memory.buffer, at, bytes.length).set(bytes)
  const answer = instance.exports[name]()
  const length = new DataView(memory.buffer).getUint32(answer, true)
  return new Uint8Array(memory.buffer, answer + 4, length).slice()
}

let told = 0
const host = {
  progress(done, total) {
    const now = Date.now()
    if (now - told < 100) return
    told = now
    postMessage({ progress: [done, total] })
  },
}

function answer(message) {
  try {
    if (message.lsp) {
      const answers = call(new TextEncoder().encode(`[${message.lsp}]`), 'lsp')
      const messages = JSON.parse(new TextDecoder().decode(answers))
      return postMessage({ lsp: messages.map(message => JSON.stringify(message)) })
    }
    const answer = call(message.question, 'ask')
    postMessage({ id: message.id, answer }, [answer.buffer])
  } catch (error) {
    postMessage({ id: message.id, failed: String(error) })
  }
}

onmessage = async event => {
  if (event.data.module) {
    instance = await WebAssembly.instantiate(event.data.module, { host })
    early.splice(0).forEach(answer)
  } else if (instance) {
    answer(event.data)
  } else {
    early.push(event.data)
  }
}
