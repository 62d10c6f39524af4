// Small help with elements of the page.

/** The element of an id. */
export const find = id => document.getElementById(id)

/** A new element with properties and children. */
export function make(tag, properties = {}, ...children) {
  const element = Object.assign(document.createElement(tag), properties)
  element.append(...children)
  return element
}

/** A line of Markdown in which only code has marks. */
export function inline(text) {
  const line = make('span')
  text.split('`').forEach((part, at) => {
    line.append(at % 2 ? make('code', {}, part) : part.replace(/[*\\]/g, ''))
  })
  return line
}

/** A picture of the server's own making: only what belongs to an image is taken from it. */
export function picture(text, title) {
  const holder = make('div', { className: 'picture' })
  const parsed = new DOMParser().parseFromString(text, 'image/svg+xml').documentElement
  if (parsed.nodeName !== 'svg') return holder
  const image = document.importNode(parsed, true)
  image.setAttribute('role', 'img')
  image.setAttribute('aria-label', title)
  // Several rules stand below each other: they need their height.
  const { width, height } = image.viewBox.baseVal
  holder.classList.toggle('tall', height > 0.8 * width)
  holder.append(image)
  return holder
}

/** The verdict on an operation, as lines. */
export function verdict({ verdict, proved }) {
  const lines = verdict.split('\n').filter(line => line.trim())
  return make('div', { className: `verdict ${proved ? 'proved' : 'rejected'}` },
    ...lines.map(line => make('p', {}, inline(line.replace(/^- /, '• ')))))
}

/** Gives a file to whoever sits before the page. */
export function download(name, bytes, type = 'application/octet-stream') {
  const link = make('a', { href: URL.createObjectURL(new Blob([bytes], { type })), download: name })
  link.click()
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000)
}

/** A number of things in words. */
export const count = (many, one, several = `${one}s`) => `${many} ${many === 1 ? one : several}`

/**
 * Lets the line between two parts be moved, by the pointer and by arrow keys: `target` gets their
 * shares as two variables.
 */
export function splitter(line, target, names, isVertical) {
  const set = share => {
    const kept = Math.min(85, Math.max(15, share))
    target.style.setProperty(names[0], `${kept}fr`)
    target.style.setProperty(names[1], `${100 - kept}fr`)
    line.setAttribute('aria-valuenow', Math.round(kept))
  }
  line.addEventListener('pointerdown', event => line.setPointerCapture(event.pointerId))
  line.addEventListener('pointermove', event => {
    if (!line.hasPointerCapture(event.pointerId)) return
    const first = line.parentElement.querySelector(`#${line.getAttribute('aria-controls')}`)
    const { left, top } = first.getBoundingClientRect()
    const { right, bottom } = target.getBoundingClientRect()
    set(100 * (isVertical
      ? (event.clientX - left) / (right - left)
      : (event.clientY - top) / (bottom - top)))
  })
  line.addEventListener('keydown', event => {
    const by = { ArrowLeft: -3, ArrowUp: -3, ArrowRight: 3, ArrowDown: 3 }[event.key]
    if (!by) return
    event.preventDefault()
    set(Number(line.getAttribute('aria-valuenow')) + by)
  })
}
