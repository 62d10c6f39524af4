// The tutorial: a text, a program with a gap, and whether it is filled.

import { marked } from 'marked'
import { find, make } from './dom.js'

const KEY = 'hedgerow-lessons'

export class Lessons {
  list = []
  current = null
  #engine
  #editor
  #open

  /** `open(lesson, text)` shows a lesson's program and mesh. */
  constructor(engine, editor, open) {
    this.#engine = engine
    this.#editor = editor
    this.#open = open
    find('lesson-check').addEventListener('click', () => this.check())
    find('lesson-next').addEventListener('click', () => this.#step(1))
    find('lesson-back').addEventListener('click', () => this.#step(-1))
    find('lesson-close').addEventListener('click', () => this.close())
  }

  async load() {
    const { json } = await this.#engine.ask({ ask: 'lessons' })
    this.list = json.lessons
  }

  get solved() {
    try {
      return new Set(JSON.parse(localStorage.getItem(KEY) ?? '[]'))
    } catch {
      return new Set()
    }
  }

  start(name) {
    const lesson = this.list.find(lesson => lesson.name === name)
    if (!lesson) return
    this.current = lesson
    const number = this.list.indexOf(lesson) + 1
    find('lesson').hidden = false
    find('lesson-title').textContent = `${number} of ${this.list.length}: ${lesson.title}`
    find('lesson-text').innerHTML = marked.parse(lesson.text)
    find('lesson-verdict').replaceChildren()
    find('lesson-back').disabled = number === 1
    find('lesson-next').disabled = number === this.list.length
    this.#open(lesson)
    find('lesson-text').scrollTop = 0
  }

  close() {
    this.current = null
    find('lesson').hidden = true
  }

  #step(by) {
    const at = this.list.indexOf(this.current) + by
    if (this.list[at]) this.start(this.list[at].name)
  }

  async check() {
    const lesson = this.current
    if (!lesson) return
    const text = this.#editor.text
    const { json } = await this.#engine.ask({ ask: 'judge', lesson: lesson.name, text })
    const verdict = find('lesson-verdict')
    if (json.solved) {
      const solved = this.solved.add(lesson.name)
      try {
        localStorage.setItem(KEY, JSON.stringify([...solved]))
      } catch { /* Nothing is kept where the browser keeps nothing. */ }
      const rest = this.list.length - solved.size
      const more = rest ? `${rest} to go.` : 'That was the last one.'
      verdict.replaceChildren(make('p', { className: 'proved' }, `Solved. ${more}`))
    } else {
      const [first, ...lines] = json.said.trim().split('\n')
      verdict.replaceChildren(make('p', { className: 'rejected' }, first),
        ...(lines.length ? [make('pre', { tabIndex: 0 }, lines.join('\n'))] : []))
    }
  }
}
