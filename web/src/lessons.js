// The tutorial: a text, a program with a gap, and whether it is filled.

import { marked } from 'marked'
import { find, inline, make } from './dom.js'
import { store, stored } from './storage.js'

const KEY = 'hedgerow-lessons'
const TEXTS = 'hedgerow-lesson-texts'

export class Lessons {
  list = []
  current = null
  #texts = new Map(Object.entries(stored(TEXTS) ?? {}))
  #engine
  #editor
  #open

  /** `open(lesson, program)` shows a program, and the mesh of the lesson. */
  constructor(engine, editor, open) {
    this.#engine = engine
    this.#editor = editor
    this.#open = open
    find('lesson-check').addEventListener('click', () => this.check())
    find('lesson-next').addEventListener('click', () => this.#step(1))
    find('lesson-back').addEventListener('click', () => this.#step(-1))
    find('lesson-close').addEventListener('click', () => this.close())
    find('lesson-again').addEventListener('click', () => this.#replace(this.current.program))
  }

  async load() {
    const { json } = await this.#engine.ask({ ask: 'lessons' })
    this.list = json.lessons
  }

  get solved() {
    return new Set([stored(KEY) ?? []].flat())
  }

  /** The name of the program of the lesson. */
  get file() {
    return this.current && `lesson_${this.current.name}.hedge`
  }

  /** The first lesson that is not solved. */
  get next() {
    const { solved } = this
    return (this.list.find(lesson => !solved.has(lesson.name)) ?? this.list[0]).name
  }

  start(name) {
    const lesson = this.list.find(lesson => lesson.name === name)
    if (!lesson) return
    this.keep()
    this.current = lesson
    const number = this.list.indexOf(lesson) + 1
    this.#toggle(true)
    find('lesson-title').textContent = `${number} of ${this.list.length}: ${lesson.title}`
    find('lesson-text').innerHTML = marked.parse(lesson.text)
    find('lesson-verdict').replaceChildren()
    find('lesson-back').disabled = number === 1
    find('lesson-next').disabled = number === this.list.length
    find('lesson-next').classList.remove('primary')
    this.#tellSolved()
    const [summary, list] = find('mistakes').children
    const { mistakes } = lesson
    find('mistakes').open = false
    summary.textContent = mistakes.length === 1 ? 'A common mistake' : `${mistakes.length} common mistakes`
    list.replaceChildren(...mistakes.map(({ title, text, program }) => {
      const attempt = make('button', { type: 'button' }, 'Try it')
      attempt.setAttribute('aria-label', `try the mistake: ${title}`)
      attempt.addEventListener('click', () => this.#replace(program))
      return make('section', {}, make('h3', {}, inline(title)), make('p', {}, inline(text)), attempt)
    }))
    this.#open(lesson, this.#texts.get(name) ?? lesson.program)
    find('lesson').scrollTop = 0
  }

  /** Another text in place of what has been written, which can be undone. */
  #replace(program) {
    this.keep()
    const file = this.#editor.files.named(this.file)
    if (!file) return this.#open(this.current, program)
    if (this.#editor.files.shown !== file) this.#editor.show(file)
    this.#editor.replace(program)
  }

  /**
   * Keeps what has been written in a lesson, and is no mistake that was tried, until one comes back. False
   * if it cannot be kept.
   */
  keep() {
    const { current } = this
    const text = current && this.#editor.files.named(this.file)?.text
    if (text === undefined || text === null) return true
    if (current.mistakes.some(mistake => mistake.program === text)) return true
    this.#texts.set(current.name, text)
    return store(TEXTS, Object.fromEntries(this.#texts))
  }

  #tellSolved() {
    find('lesson-solved').textContent = this.solved.has(this.current.name) ? '✓ solved' : ''
    this.onSolved()
  }

  /** Called when lessons may have been solved. */
  onSolved = () => {}

  close() {
    this.keep()
    this.current = null
    this.#toggle(false)
  }

  #toggle(isOpen) {
    find('lesson').hidden = !isOpen
    find('lesson').parentElement.classList.toggle('teaching', isOpen)
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
      store(KEY, [...solved])
      const rest = this.list.length - solved.size
      const more = rest > 0 ? `${rest} to go.` : 'That was the last one.'
      verdict.replaceChildren(make('p', { className: 'proved' }, `Solved. ${more}`))
      find('lesson-next').classList.add('primary')
      this.#tellSolved()
    } else {
      const [first, ...lines] = json.said.trim().split('\n')
      const known = json.mistake ? [make('p', {}, 'A common mistake: ', inline(json.mistake))] : []
      verdict.replaceChildren(...known,
        make('p', { className: 'rejected' }, inline(first.replace(/^error\[[\w-]+\]: /, ''))),
        ...(lines.length ? [make('details', {}, make('summary', {}, 'All of it'),
          make('pre', { tabIndex: 0 }, lines.join('\n')))] : []))
    }
  }
}
