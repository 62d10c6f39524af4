// Values in this browser, kept until the next time, where it keeps any. Of several pages in one browser
// the first keeps values, and after it the next, so that none overwrites those of another.

/** What is kept under a key, or null. */
export function stored(key) {
  try {
    return JSON.parse(localStorage.getItem(key))
  } catch {
    return null
  }
}

/** Whether another page of this browser keeps values. */
export let isElsewhere = Boolean(navigator.locks)

navigator.locks?.request('hedgerow', () => {
  isElsewhere = false
  return new Promise(() => {})
})

/** Keeps a value, and says whether it could. */
export function store(key, value) {
  if (isElsewhere) return false
  try {
    localStorage.setItem(key, JSON.stringify(value))
    return true
  } catch {
    return false
  }
}
