// Values in this browser, kept until the next time, where it keeps any.

/** What is kept under a key, or null. */
export function stored(key) {
  try {
    return JSON.parse(localStorage.getItem(key))
  } catch {
    return null
  }
}

/** Keeps a value, and says whether it could. */
export function store(key, value) {
  try {
    localStorage.setItem(key, JSON.stringify(value))
    return true
  } catch {
    return false
  }
}
