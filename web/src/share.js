// Programs as part of an address: compressed, in the fragment, which no server ever sees. And kept in
// this browser until the next time.

import { store, stored } from './storage.js'

const KEY = 'hedgerow-work'
const EARLIER = 'hedgerow-earlier-work'

async function through(bytes, stream) {
  const response = new Response(new Blob([bytes]).stream().pipeThrough(stream))
  return new Uint8Array(await response.arrayBuffer())
}

/** The fragment for what is open: `{ files: [[name, text]], mesh }`. */
export async function fragment(work) {
  const bytes = new TextEncoder().encode(JSON.stringify(work))
  const small = await through(bytes, new CompressionStream('deflate-raw'))
  let binary = ''
  for (const byte of small) binary += String.fromCharCode(byte)
  const code = btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '')
  return `#p=${code}`
}

/** What a fragment shares; null if it shares nothing. A damaged one is an error. */
export async function shared(fragment) {
  if (!fragment.startsWith('#p=')) return null
  const code = fragment.slice(3)
  try {
    const binary = atob(code.replaceAll('-', '+').replaceAll('_', '/'))
    const bytes = Uint8Array.from(binary, letter => letter.charCodeAt(0))
    const text = await through(bytes, new DecompressionStream('deflate-raw'))
    const work = sound(JSON.parse(new TextDecoder().decode(text)))
    if (work) return work
  } catch { /* The error below says what can be said. */ }
  throw new Error('The link is damaged, or cut off: the program that it shares cannot be read.')
}

/** Keeps what is open in this browser, where it can be. */
export const keep = work => store(KEY, work)

/** What was open the last time. */
export const kept = () => sound(stored(KEY))

/** What was kept whenever a link was opened and changed, the last first. */
export const earlier = () => [stored(EARLIER) ?? []].flat().map(sound).filter(Boolean)

/** Puts what is kept aside, beside all that was put there before, and says whether it could. */
export function setAside() {
  const work = { ...kept(), time: Date.now() }
  const others = earlier().filter(it => JSON.stringify(it.files) !== JSON.stringify(work.files))
  return store(EARLIER, [work, ...others])
}

/** Programs with their names, at least one; nothing if it is something else. */
function sound(work) {
  const files = work?.files?.filter?.(file =>
    Array.isArray(file) && file.length === 2 && file.every(it => typeof it === 'string'))
  return files?.length ? { files, mesh: String(work.mesh ?? ''), time: Number(work.time ?? 0) } : null
}
