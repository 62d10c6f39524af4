// The fields for the parameters of an operation or a script.

import { find, make } from './dom.js'

/** A field for each parameter but one. */
export function fields(id, item, without) {
  const parameters = item?.parameters.filter(([name]) => name !== without) ?? []
  const known = Object.fromEntries(
    [...find(id).querySelectorAll('input')].map(input => [input.name, input.value]))
  find(id).replaceChildren(...parameters.map(([name, type, standard]) => make('label', {},
    `${name} `, make('input', {
      name, value: known[name] ?? '', placeholder: standard ?? type, size: 7,
      title: `${name}: ${type}`,
    }))))
}

/** The values of the fields that are filled. */
export function given(id, item) {
  const values = {}
  for (const input of find(id).querySelectorAll('input')) {
    const text = input.value.trim()
    if (!text) continue
    const type = item.parameters.find(([name]) => name === input.name)?.[1]
    values[input.name] = value(text, type)
  }
  return values
}

function value(text, type) {
  if (type === 'bool') return text === 'true'
  if (type === 'text') return text
  const numbers = text.split(/[\s,]+/).map(part => {
    const [over, under] = part.split('/').map(Number)
    return under === undefined ? over : over / under
  })
  return type?.startsWith('vec') ? numbers : numbers[0]
}
