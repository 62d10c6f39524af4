// What is wrong with the program, in words, with what mends it.

import { count, find, inline, make } from './dom.js'

/** The number of problems that are listed. */
const MOST = 12

/** Lists the diagnostics of the editor; `go(offset)` goes to a place. */
export function showProblems(list, go) {
  const errors = list.filter(({ severity }) => severity === 'error')
  const holder = find('problems')
  holder.hidden = !list.length
  holder.replaceChildren(...list.slice(0, MOST).map(({ from, severity, message, actions }) => {
    const [first, ...notes] = message.split('\n')
    const place = make('button', { type: 'button', className: 'plain' }, inline(first))
    place.addEventListener('click', () => go(from))
    const fixes = actions.map(({ name, apply }) => {
      const fix = make('button', { type: 'button', className: 'fix' }, name)
      fix.addEventListener('click', apply)
      return fix
    })
    const more = notes.filter(line => line.trim()).map(line => make('p', { className: 'note' }, inline(line)))
    return make('div', { className: `problem ${severity}` }, place, ...fixes, ...more)
  }))
  if (list.length > MOST) holder.append(make('p', { className: 'note' }, `and ${list.length - MOST} more`))
  holder.setAttribute('aria-label', errors.length ? count(errors.length, 'error') : 'remarks')
}
