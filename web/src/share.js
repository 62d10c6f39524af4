// A program as part of an address: compressed, in the fragment, which no server ever sees.

async function through(bytes, stream) {
  const response = new Response(new Blob([bytes]).stream().pipeThrough(stream))
  return new Uint8Array(await response.arrayBuffer())
}

/** The fragment for what is open: `{ name, text, mesh }`. */
export async function fragment(shared) {
  const bytes = new TextEncoder().encode(JSON.stringify(shared))
  const small = await through(bytes, new CompressionStream('deflate-raw'))
  let binary = ''
  for (const byte of small) binary += String.fromCharCode(byte)
  const code = btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '')
  return `#p=${code}`
}

/** What a fragment shares; nothing if it is none, or damaged. */
export async function shared(fragment) {
  const code = /^#p=([\w-]+)$/.exec(fragment)?.[1]
  if (!code) return null
  try {
    const binary = atob(code.replaceAll('-', '+').replaceAll('_', '/'))
    const bytes = Uint8Array.from(binary, letter => letter.charCodeAt(0))
    const text = await through(bytes, new DecompressionStream('deflate-raw'))
    const { name, text: program, mesh } = JSON.parse(new TextDecoder().decode(text))
    if (typeof program !== 'string') return null
    return { name: String(name ?? 'shared.hedge'), text: program, mesh: String(mesh ?? '') }
  } catch {
    return null
  }
}
