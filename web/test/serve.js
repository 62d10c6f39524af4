// A folder behind a web server on loopback, for the tests.

import { createReadStream, existsSync } from 'node:fs'
import { createServer } from 'node:http'
import { extname, join, normalize } from 'node:path'

const TYPES = {
  '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.css': 'text/css',
  '.wasm': 'application/wasm', '.svg': 'image/svg+xml', '.obj': 'text/plain', '.txt': 'text/plain',
}

/** Serves a folder; promises its address, how to be silent for a while, and how to end. */
export function serve(folder) {
  const asked = []
  const server = createServer((request, response) => {
    const { pathname } = new URL(request.url, 'http://localhost')
    asked.push(pathname)
    const path = normalize(join(folder, pathname === '/' ? 'index.html' : pathname))
    if (!path.startsWith(folder) || !existsSync(path)) return response.writeHead(404).end()
    response.writeHead(200, { 'content-type': TYPES[extname(path)] ?? 'application/octet-stream' })
    createReadStream(path).pipe(response)
  })
  return new Promise(resolve => {
    server.listen(0, '127.0.0.1', () => {
      const end = () => new Promise(ended => {
        server.closeAllConnections()
        server.close(ended)
      })
      const { port } = server.address()
      const pause = () => end()
      const resume = () => new Promise(resumed => server.listen(port, '127.0.0.1', resumed))
      resolve({ address: `http://127.0.0.1:${port}/`, asked, pause, resume, end })
    })
  })
}
