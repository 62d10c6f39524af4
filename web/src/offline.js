// Keeps the page, so that it opens without a network. With one, the newest is taken.
// FILES and VERSION are put in by the build.

const name = `hedgerow-${VERSION}`

self.addEventListener('install', event => {
  event.waitUntil(caches.open(name).then(cache => cache.addAll(FILES)))
})

self.addEventListener('activate', event => {
  event.waitUntil((async () => {
    for (const other of await caches.keys()) {
      if (other.startsWith('hedgerow-') && other !== name) await caches.delete(other)
    }
    await self.clients.claim()
  })())
})

self.addEventListener('fetch', event => {
  if (event.request.method !== 'GET') return
  event.respondWith((async () => {
    try {
      return await fetch(event.request)
    } catch (error) {
      const known = await caches.match(event.request, { ignoreSearch: true, ignoreVary: true })
      if (!known) throw error
      return known
    }
  })())
})
