// Small help with elements of the page.

/** The element of an id. */
export const find = id => document.getElementById(id)

/** A new element with properties and children. */
export function make(tag, properties = {}, ...children) {
  const element = Object.assign(document.createElement(tag), properties)
  element.append(...children)
  return element
}

/** Gives a file to whoever sits before the page. */
export function download(name, bytes, type = 'application/octet-stream') {
  const link = make('a', { href: URL.createObjectURL(new Blob([bytes], { type })), download: name })
  link.click()
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000)
}
