// The fields for the parameters of an operation or a script.

import { find, make } from './dom.js'

/** A field for each parameter but one. */
export function fields(id, item, without) {
  const parameters = item?.parameters.filter(([name]) => name !== without) ?? []
  const known = Object.fromEntries(
    [...find(id).querySelectorAll('input, select')].map(field => [field.name, field.value]))
  find(id).replaceChildren(...parameters.map(([name, type, standard]) => {
    const title = `${name}: ${type}`
    const field = type === 'bool'
      ? make('select', { name, title }, new Option(standard ?? type, ''), new Option('true'), new Option('false'))
      : make('input', { name, title, placeholder: standard ?? type, size: 7 })
    field.value = known[name] ?? ''
    return make('label', {}, `${name} `, field)
  }))
}

/** The values of the fields that are filled; an error for one that is not wholly of its type. */
export function given(id, item) {
  const values = {}
  for (const field of find(id).querySelectorAll('input, select')) {
    const text = field.value.trim()
    if (!text) continue
    const type = item.parameters.find(([name]) => name === field.name)?.[1]
    values[field.name] = value(field.name, text, type)
  }
  return values
}

function value(name, text, type) {
  if (type === 'bool') return text === 'true'
  if (type === 'text') return text
  const size = { vec2: 2, vec3: 3, vec4: 4, mat3: 9, mat4: 16 }[type]
  const numbers = size
    ? text.replace(RegExp(`^(?:${type}\\s*)?\\((.*)\\)$`), '$1').trim().split(/\s*,\s*|\s+/).map(number)
    : [number(text)]
  const isWhole = type !== 'real' && !size
  if (numbers.length !== (size ?? 1)
    || !numbers.every(isWhole ? Number.isSafeInteger : Number.isFinite)) {
    const wanted = size ? `${size} numbers` : isWhole ? 'a whole number' : 'a number, as 0.5 or 1/2'
    throw new Error(`${name} is ${wanted}, not "${text}"`)
  }
  return size ? numbers : numbers[0]
}

/** A number, or a quotient of two; NaN for anything else. */
function number(text) {
  const parts = text.split('/').map(part =>
    /^\s*[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?\s*$/i.test(part) ? Number(part) : NaN)
  if (parts.length > 2) return NaN
  return parts.length === 2 ? parts[0] / parts[1] : parts[0]
}
