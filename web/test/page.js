// The page in a headless browser: type, break, fix, run, click an edge, share, reopen, solve every
// lesson. `node --test test/page.js`; `SCREENSHOTS=folder` keeps pictures, `CHROMIUM` names the browser.

import assert from 'node:assert/strict'
import { readFileSync, readdirSync } from 'node:fs'
import { join } from 'node:path'
import { createRequire } from 'node:module'
import { after, before, test } from 'node:test'
import { end, faults, here, keep, open, server, start } from './browser.js'

let page

before(async () => {
  await start()
  page = await open('')
}, { timeout: 120_000 })

after(end)

const picture = (name, of = page) => keep(name, of)

const text = id => page.locator(`#${id}`).innerText()

/** Puts a program into the editor, as somebody who pastes it. */
async function write(program) {
  await page.locator('.cm-content').click()
  await page.keyboard.press('Control+a')
  await page.keyboard.insertText(program)
  await page.keyboard.press('Control+Home')
}

async function choose(id, value) {
  await page.selectOption(`#${id}`, value)
}

/** Waits until something is said that fits. */
async function said(id, pattern, timeout = 30_000) {
  await page.waitForFunction(
    ([id, source]) => new RegExp(source).test(document.getElementById(id).textContent),
    [id, pattern.source], { timeout })
}

test('the first program is there, proved, with its diagram and a mesh', async () => {
  await page.waitForSelector('#pane svg')
  await said('counts', /162 vertices, 480 edges, 320 faces/)
  assert.match(await text('pane'), /proved/i)
  await page.waitForSelector('.tok-keyword')
  assert.ok(await page.locator('#undo').isDisabled(), 'there is nothing to undo')
  await picture('first')
})

test('an edge is clicked: names show, the operation applies, undo and redo', async () => {
  await page.locator('#places').check()
  await said('where', /applies at \d+ of 480 places/)
  const box = await page.locator('#view').boundingBox()
  const middle = [box.x + box.width / 2 + 5, box.y + box.height / 2 + 8]
  await page.mouse.move(...middle)
  await said('said', /applies at edge \d+|refuses at edge \d+/)
  await page.waitForSelector('.label')
  await picture('names')
  await page.mouse.click(...middle)
  await said('said', /applied at edge \d+|refuses/)
  assert.match(await text('said'), /applied/)
  await page.locator('#undo').click()
  await page.waitForFunction(() => !document.getElementById('redo').disabled)
  await page.locator('#redo').click()
  await page.locator('#places').uncheck()
})

test('what is broken is told, shown, and mended by a fix', async () => {
  const broken = readFileSync(join(here, '../../examples/split.hedge'), 'utf8')
    .replaceAll('edge e2: p | r    edge e3: s | u', 'edge e2: p | r')
  await write(broken)
  await said('problems', /e3/)
  await page.waitForSelector('#stale', { state: 'visible' })
  await page.locator('#tab-counterexample').click()
  await picture('broken')
  await page.keyboard.press('Escape')
  await page.locator('.cm-lint-marker-error').first().hover()
  await page.waitForSelector('.cm-diagnosticAction')
  await picture('fix')
  await page.mouse.move(5, 5)
  await page.locator('#problems .fix').first().click()
  await page.waitForSelector('#problems', { state: 'hidden' })
  await page.locator('#tab-diagram').click()
})

test('a forgotten twin breaks a mesh, which is shown', async () => {
  await choose('program', 'lesson:04_outside')
  await said('problems', /twin/)
  await said('breaks', /^1$/)
  await said('nothing', /has errors/)
  await page.waitForTimeout(300)
  await page.locator('#tab-counterexample').click()
  await page.waitForSelector('.counterexample svg')
  await page.locator('.counterexample button').first().click()
  await said('said', /carried out on this mesh/)
  const twins = page.locator('.label-pointer', { hasText: 'twin' })
  await twins.nth(1).waitFor() // it is drawn with the next frame
  assert.equal(await twins.count(), 2)
  await picture('counterexample')
  await page.locator('#said button').click()
  await said('counts', /162 vertices/)
  await page.locator('#tab-diagram').click()
})

test('every lesson is solved by its solution and not before', async () => {
  const folder = join(here, '../../src/lessons/texts')
  const files = readdirSync(folder).filter(name => name.endsWith('.md')).sort()
  assert.equal(files.length, 15)
  for (const file of files) {
    const name = file.replace('.md', '')
    await choose('program', `lesson:${name}`)
    await page.waitForSelector('#lesson:not([hidden])')
    await page.locator('#lesson-check').click()
    await page.waitForSelector('#lesson-verdict .rejected', { timeout: 60_000 })
    if (file.startsWith('03')) {
      await page.locator('#mistakes summary').click()
      await picture('lesson')
    }
    const program = readFileSync(join(folder, file), 'utf8').split('```hedge\n')[1]
    const lines = program.split('```')[0].split('\n')
    await write(lines.filter(line => !line.startsWith('//')).join('\n'))
    await page.waitForTimeout(200)
    await page.locator('#lesson-check').click()
    await page.waitForSelector('#lesson-verdict .proved', { timeout: 60_000 })
  }
  assert.match(await text('lesson-verdict'), /That was the last one/)
  await picture('solved')
})

test('a common mistake is tried, told by its name, and what was written is there again', async () => {
  await choose('program', 'lesson:09_link')
  assert.match(await page.locator('.cm-content').innerText(), /require link_condition/)
  await page.locator('#mistakes summary').click()
  await page.locator('#mistakes button').first().click()
  await page.locator('#lesson-check').click()
  await said('lesson-verdict', /A common mistake: An edge is collapsed without the link condition/)
  await picture('mistake')
  await page.locator('#lesson-again').click()
  assert.match(await page.locator('.cm-content').innerText(), /Here a condition is missing/)
  await page.locator('#lesson-close').click()
})

test('a script runs, is stepped through, and the bunny is remeshed', async () => {
  await choose('shape', 'bunny')
  await said('counts', /1839 vertices/)
  await choose('program', 'example:remesh.hedge')
  await page.waitForFunction(() => document.getElementById('script').value === 'remesh')
  await page.locator('#run').click()
  await said('report', /split/, 60_000)
  await said('counts', /1619 vertices, 4851 edges, 3234 faces/)
  await picture('remeshed')
  const step = page.locator('#step')
  const total = Number(await step.getAttribute('max'))
  assert.equal(total, 640 + 860 + 826)
  await step.fill('3')
  await said('step-count', /^3 of/)
  await page.locator('#step-on').click()
  await said('step-count', /^4 of/)
  await said('counts', /1843 vertices/)
  await page.locator('#step-back').click()
  await said('step-count', /^3 of/)
  await said('counts', /1842 vertices/)
  await step.focus()
  await page.keyboard.press('End')
  await said('counts', /1619 vertices, 4851 edges, 3234 faces/)
  await page.keyboard.press('ArrowLeft')
  await said('step-count', new RegExp(`^${total - 1} of`))
  await page.keyboard.press('Home')
  await said('counts', /1839 vertices, 5511 edges/)
  await page.locator('#undo').click()
  await said('counts', /1839 vertices/)
})

test('plan, C++ and Rust of an operation', async () => {
  await choose('program', 'example:flip.hedge')
  await page.waitForSelector('#pane svg')
  for (const [tab, pattern] of [['plan', /Reassign/], ['cpp', /halfedge/], ['rust', /pub fn/]]) {
    await page.locator(`#tab-${tab}`).click()
    await said('pane', pattern)
  }
  await picture('code')
  await page.locator('#tab-diagram').click()
})

test('a program is shared by its address and opened again', async () => {
  await write('/// Mine.\nop mine(f: face) { before { face f: a -h-> b =P=> a } after { face f: a -h-> b =P=> a } }\n')
  await page.locator('#share').click()
  await said('shared', /address/)
  const { hash } = new URL(page.url())
  assert.match(hash, /^#p=/)
  const other = await open(hash)
  assert.match(await other.locator('.cm-content').innerText(), /op mine/)
  assert.equal(await other.locator('#files .file').count(), await page.locator('#files .file').count())
  await other.context().close()
  const damaged = await open('#p=AAAA')
  assert.match(await damaged.locator('.cm-content').innerText(), /op flip/)
  assert.match(await damaged.locator('#said').innerText(), /link is damaged/)
  await damaged.context().close()
})

/** Puts a program of one line into the editor. */
const put = async (of, words) => {
  await of.locator('.cm-content').press('Control+a')
  await of.keyboard.insertText(`// ${words}`)
}
const reloaded = async of => {
  await of.reload()
  await of.waitForSelector('body[data-ready]', { timeout: 60_000 })
  return of.locator('.cm-content').innerText()
}
const untilKept = (of, words) => of.waitForFunction(
  words => localStorage.getItem('hedgerow-work')?.includes(words), words)

test('what is written after sharing, or before a link is opened, is there again', async () => {
  const own = await open('')
  await put(own, 'first')
  await untilKept(own, '// first')
  await own.locator('#share').click()
  await own.waitForFunction(() => location.hash.startsWith('#p='))
  const link = new URL(own.url()).hash
  await put(own, 'first and second')
  await untilKept(own, 'second')
  assert.equal(new URL(own.url()).hash, '')
  assert.equal(await own.locator('#program [value^=earlier]').count(), 0)
  assert.match(await reloaded(own), /second/)
  // What is there again is not replaced by an example of its name.
  await own.selectOption('#program', 'example:flip.hedge')
  assert.equal(await own.locator('#files .file').count(), 2)
  await own.locator('#files .file').first().click()
  // A link is shown beside what is changed, and what was kept remains until it is changed, too.
  await put(own, 'third')
  await untilKept(own, 'third')
  await own.evaluate(hash => { location.hash = hash }, link)
  await own.waitForFunction(() => !document.querySelector('.cm-content').innerText.includes('third'))
  assert.equal(await own.locator('#files .file').count(), 3)
  assert.doesNotMatch(await reloaded(own), /second|third/)
  assert.match(await own.evaluate(() => localStorage.getItem('hedgerow-work')), /third/)
  await put(own, 'fourth')
  await untilKept(own, 'fourth')
  await own.selectOption('#program', 'earlier:0')
  await own.waitForFunction(() => document.querySelector('.cm-content').innerText.includes('third'))
  await own.context().close()
})

test('what is shared or followed by a link at once after writing is kept', async () => {
  const own = await open('')
  // In one go, so that nothing is kept a moment after writing.
  const press = (words, then) => own.evaluate(async ([words, then]) => {
    const content = document.querySelector('.cm-content')
    content.focus()
    document.execCommand('selectAll')
    document.execCommand('insertText', false, `// ${words}`)
    await new Promise(requestAnimationFrame)
    if (then) location.hash = then
    else document.getElementById('share').click()
  }, [words, then])
  await press('of a link')
  await own.waitForFunction(() => location.hash.startsWith('#p='))
  const link = new URL(own.url()).hash
  await put(own, 'mine')
  await untilKept(own, '// mine')
  assert.equal(await own.locator('#program [value^=earlier]').count(), 0)
  await press('mine to the end', link)
  await own.waitForFunction(() => document.querySelector('.cm-content').innerText === '// of a link')
  assert.match(await own.evaluate(() => localStorage.getItem('hedgerow-work')), /mine to the end/)
  await own.context().close()
})

test('what is closed stays closed, a mesh that is chosen and what was written last are there again', async () => {
  const own = await open('')
  const counts = pattern => own.waitForFunction(
    source => new RegExp(source).test(document.getElementById('counts').textContent), pattern.source)
  await put(own, 'first')
  await own.getByRole('button', { name: 'a new program' }).click()
  await put(own, 'second')
  await untilKept(own, '// second')
  own.on('dialog', dialog => dialog.accept())
  await own.locator('#files .close').first().click()
  await own.waitForFunction(() => !localStorage.getItem('hedgerow-work').includes('first'))
  assert.match(await reloaded(own), /second/)
  assert.equal(await own.locator('#files .file').count(), 1)
  for (const [shape, pattern] of [['cube', /^8 vertices/], ['bunny', /^1839 vertices/]]) {
    await own.selectOption('#shape', shape)
    await counts(pattern)
    assert.match(await reloaded(own), /second/)
    await counts(pattern)
  }
  // At once, sooner than a pause in typing is waited for.
  await put(own, 'last')
  assert.match(await reloaded(own), /last/)
  await own.context().close()
})

test('a link opens its mesh, on a page that is open as well', async () => {
  const own = await open('')
  const counts = of => of.waitForFunction(
    () => /^8 vertices/.test(document.getElementById('counts').textContent))
  await own.selectOption('#shape', 'cube')
  await counts(own)
  await put(own, 'with a cube')
  await untilKept(own, 'with a cube')
  await own.locator('#share').click()
  await own.waitForFunction(() => location.hash.startsWith('#p='))
  const link = new URL(own.url()).hash
  await own.context().close()
  const other = await open('')
  await put(other, 'mine')
  await untilKept(other, '// mine')
  await other.evaluate(hash => { location.hash = hash }, link)
  await other.waitForFunction(() => document.querySelector('.cm-content').innerText === '// with a cube')
  await counts(other)
  // What is one's own keeps its mesh until the link is changed.
  const { mesh } = JSON.parse(await other.evaluate(() => localStorage.getItem('hedgerow-work')))
  assert.equal(mesh, 'icosphere')
  assert.match(await reloaded(other), /with a cube/)
  await counts(other)
  await other.context().close()
})

test('of several links in turn, each that is changed leaves all that was before it', async () => {
  const own = await open('')
  await put(own, 'of a link')
  await own.locator('#share').click()
  await own.waitForFunction(() => location.hash.startsWith('#p='))
  const link = new URL(own.url()).hash
  // As an earlier page has kept it.
  await own.evaluate(() => localStorage.setItem('hedgerow-earlier-work', '{"files":[["old.hedge","// old"]],"mesh":""}'))
  await put(own, 'mine')
  await untilKept(own, '// mine')
  for (const words of ['one more', 'two more']) {
    await own.goto('about:blank')
    await own.goto(server().address + link)
    await own.waitForSelector('body[data-ready]')
    await put(own, words)
    await untilKept(own, words)
  }
  const listed = await own.locator('#program [value^=earlier]').allTextContents()
  assert.equal(listed.length, 3)
  assert.match(listed[0], /^flip\.hedge \(.*\d.*\)$/)
  for (const [at, words] of [[2, 'old'], [1, 'mine'], [0, 'one more']]) {
    await own.selectOption('#program', `earlier:${at}`)
    await own.waitForFunction(words => document.querySelector('.cm-content').innerText.includes(words), words)
  }
  await own.context().close()
})

test('what is written while a script runs is kept', async () => {
  const own = await open('')
  await own.locator('.cm-content').press('Control+a')
  await own.keyboard.insertText('script forever() { var n = 0 while n >= 0 { n = 1 - n } }\n')
  await own.waitForFunction(() => document.getElementById('script').value === 'forever')
  await own.locator('#run').click()
  await own.locator('#stop').waitFor()
  await put(own, 'meanwhile')
  await untilKept(own, '// meanwhile')
  assert.ok(await own.locator('#stop').isVisible())
  assert.match(await reloaded(own), /meanwhile/)
  await own.context().close()
})

test('where the storage is full it is said, and what is kept stays until there is room', async () => {
  const own = await open('')
  const warned = () => own.waitForFunction(() => /storage is full/.test(document.getElementById('shared').textContent))
  const fill = () => own.evaluate(() => {
    for (let part = 'x'.repeat(2 ** 22), at = 0; part; at++) {
      try {
        localStorage.setItem(`fill${at}`, part)
      } catch {
        part = part.slice(part.length / 2 + 0.5)
      }
    }
  })
  const free = () => own.evaluate(() => Object.keys(localStorage).filter(key => key.startsWith('fill'))
    .forEach(key => localStorage.removeItem(key)))
  await put(own, 'of a link')
  await own.locator('#share').click()
  await own.waitForFunction(() => location.hash.startsWith('#p='))
  const link = new URL(own.url()).hash
  await put(own, 'mine')
  await untilKept(own, '// mine')
  await fill()
  await put(own, `mine, and ${'more '.repeat(900)}`)
  await warned()
  await picture('full', own)
  // What cannot be put aside is not overwritten.
  await own.evaluate(hash => { location.hash = hash }, link)
  await own.waitForFunction(() => document.querySelector('.cm-content').innerText === '// of a link')
  await put(own, 'x')
  await warned()
  assert.match(await own.evaluate(() => localStorage.getItem('hedgerow-work')), /\/\/ mine/)
  await free()
  await put(own, 'changed')
  await untilKept(own, '// changed')
  assert.equal(await own.locator('#program [value^=earlier]').count(), 1)
  await own.waitForFunction(() => !/storage/.test(document.getElementById('shared').textContent))
  await own.context().close()
})

test('of two tabs the second does not overwrite what the first keeps, until that is closed', async () => {
  const first = await open('')
  const second = await first.context().newPage()
  await second.goto(first.url())
  await second.waitForSelector('body[data-ready]')
  await put(first, 'one')
  await untilKept(first, '// one')
  await put(second, 'two')
  await second.waitForFunction(() => /another tab/.test(document.getElementById('shared').textContent))
  assert.match(await second.evaluate(() => localStorage.getItem('hedgerow-work')), /one/)
  await first.close()
  await put(second, 'three')
  await untilKept(second, '// three')
  await second.context().close()
})

test('what is written in a lesson is there again, and beside it all else', async () => {
  const own = await open('')
  await put(own, 'mine')
  await untilKept(own, '// mine')
  await own.selectOption('#program', 'lesson:09_link')
  await put(own, 'learnt')
  await own.waitForFunction(() => localStorage.getItem('hedgerow-lesson-texts')?.includes('// learnt'))
  await own.locator('#lesson-again').click()
  assert.doesNotMatch(await own.locator('.cm-content').innerText(), /learnt/)
  await own.locator('.cm-content').press('Control+z')
  assert.match(await own.locator('.cm-content').innerText(), /learnt/)
  await own.locator('#mistakes summary').click()
  await own.locator('#mistakes button').first().click()
  await own.locator('#lesson-next').click()
  await own.locator('#lesson-back').click()
  assert.match(await own.locator('.cm-content').innerText(), /learnt/)
  assert.match(await reloaded(own), /mine/)
  await own.selectOption('#program', 'lesson:09_link')
  assert.match(await own.locator('.cm-content').innerText(), /learnt/)
  await own.context().close()
})

test('a field that does not hold a value of its type is told, with what stands there', async () => {
  const own = await open('')
  await own.locator('.cm-content').press('Control+a')
  await own.keyboard.insertText(`script go(x: real, n: int, p: vec3, b: bool) { print "{x} {n} {p.x + p.y + p.z} {b}" }\n`)
  const field = name => own.locator(`#script-fields [name=${name}]`)
  await field('b').waitFor()
  await field('b').selectOption('true')
  const run = async (x, n, p) => {
    for (const [name, text] of Object.entries({ x, n, p })) await field(name).fill(text)
    await own.locator('#run').click()
  }
  const says = (id, words) => own.waitForFunction(
    ([id, words]) => document.getElementById(id).innerText.includes(words), [id, words])
  await run('1/2', '7', 'vec3(1, 2, 3)')
  await says('report', '0.5 7 6 true')
  for (const [x, n, p, told] of [
    ['0,5', '7', '1 2 3', 'x is a number, as 0.5 or 1/2, not "0,5"'],
    ['1/2/4', '7', '1 2 3', 'not "1/2/4"'],
    ['1', '9007199254740993', '1 2 3', 'n is a whole number, not "9007199254740993"'],
    ['1', '7', '1, 2', 'p is 3 numbers, not "1, 2"'],
    ['1', '7', 'mat3(1, 2, 3)', 'p is 3 numbers'],
  ]) {
    await run(x, n, p)
    await says('said', told)
    assert.equal(await own.locator('#report').innerText(), '')
  }
  await run('1', '7', '(1, 2, 3)')
  await says('report', '1 7 6 true')
  await own.context().close()
})

test('files are dropped, repaired and saved', async () => {
  const file = (name, body) => ({ name, mimeType: 'text/plain', buffer: Buffer.from(body) })
  await page.locator('#file').setInputFiles(file('tri.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n'))
  await said('counts', /3 vertices, 3 edges, 1 face, 1 hole/)
  await page.locator('#file').setInputFiles(file('bow.obj',
    'v 0 0 0\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nf 1 2 3\nf 1 4 5\n'))
  await page.locator('#said button').click()
  await said('said', /repaired: split off 1 vertex/)
  await page.locator('#file').setInputFiles(file('bad.obj', 'v 0 0 nonsense\n'))
  await said('said', /bad.obj/)
})

/** What is downloaded as this, and its name. */
async function saved(what) {
  await page.locator('#save summary').click()
  const [download] = await Promise.all([
    page.waitForEvent('download'), page.locator(`#save [value=${what}]`).click(),
  ])
  return [readFileSync(await download.path(), 'utf8'), download.suggestedFilename()]
}

test('mesh, picture and program are downloaded', async () => {
  await choose('shape', 'cube')
  await said('counts', /8 vertices, 12 edges, 6 faces/)
  await choose('program', 'example:flip.hedge')
  await page.waitForSelector('#pane svg')
  const [mesh, name] = await saved('obj')
  assert.equal(name, 'cube.obj')
  assert.deepEqual(['v ', 'f '].map(start => mesh.split('\n').filter(line => line.startsWith(start)).length), [8, 6])
  const [ply] = await saved('ply')
  assert.match(ply, /^ply[^]*element vertex 8[^]*element face 6/)
  const [program, file] = await saved('hedge')
  assert.match(file, /^flip\d*\.hedge$/)
  assert.equal(program, readFileSync(join(here, '../../examples/flip.hedge'), 'utf8'))
  const [picture] = await saved('svg')
  assert.match(picture, /^<svg [^]*<\/svg>\s*$/)
})

test('by keys, what to save is chosen first and saved then', async () => {
  const own = await open('')
  const downloads = []
  own.on('download', download => downloads.push(download.suggestedFilename()))
  const isOpen = () => own.locator('#save').evaluate(save => save.open)
  await own.locator('#save summary').focus()
  await own.keyboard.press('ArrowDown')
  await own.keyboard.press('Enter')
  assert.ok(await isOpen())
  await picture('save', own)
  await own.keyboard.press('Tab')
  await own.keyboard.press('Escape')
  assert.ok(!await isOpen())
  assert.equal(await own.evaluate(() => document.activeElement.tagName), 'SUMMARY')
  assert.deepEqual(downloads, [])
  await own.keyboard.press('Enter')
  for (let at = 0; at < 5; at++) await own.keyboard.press('Tab')
  await Promise.all([own.waitForEvent('download'), own.keyboard.press('Enter')])
  assert.deepEqual(downloads, ['flip.hedge'])
  assert.ok(!await isOpen())
  await own.locator('#save summary').click()
  await own.locator('h1').click()
  assert.ok(!await isOpen())
  for (const [name, options] of [['save-dark', { colorScheme: 'dark' }], ['save-phone', { viewport: { width: 390, height: 844 } }]]) {
    const other = await open('', options)
    await other.locator('#save summary').click()
    const { x, width } = await other.locator('#save div').boundingBox()
    assert.ok(x >= 0 && x + width <= other.viewportSize().width, name)
    await picture(name, other)
    await other.context().close()
  }
  await own.context().close()
})

test('a mesh is dropped; faces and vertices are clicked', async () => {
  const own = await open('')
  const at = (id, pattern) => own.waitForFunction(
    ([id, source]) => new RegExp(source).test(document.getElementById(id).textContent), [id, pattern.source])
  await own.evaluate(() => {
    const data = new DataTransfer()
    data.items.add(new File(['v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nf 1 2 3\nf 1 3 4\n'], 'flat.obj'))
    document.dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true }))
  })
  await at('said', /flat.obj is open/)
  await at('counts', /4 vertices, 5 edges, 2 faces, 1 hole/)
  await own.locator('.cm-content').click()
  await own.keyboard.press('Control+a')
  await own.keyboard.insertText('op drop(f: face) {\n  before { face f: v -h-> w =P=> v }\n  after { keep f v.position = 0.9 * v.position }\n}\n'
    + 'op nudge(v: vertex) {\n  before { face f: v -h-> w =P=> v }\n  after { keep f v.position = 0.9 * v.position }\n}\n')
  await own.waitForFunction(() => [...document.getElementById('op').options].some(({ value }) => value === 'nudge'))
  for (const [op, kind] of [['drop', 'face'], ['nudge', 'vertex']]) {
    await own.selectOption('#op', op)
    await own.locator('#places').check()
    await at('where', new RegExp(`applies at ${kind === 'face' ? 2 : 4} of`))
    const box = await own.locator('#view').boundingBox()
    await own.mouse.click(box.x + box.width / 2 + 12, box.y + box.height / 2 + 5)
    await at('said', new RegExp(`${op} applied at ${kind} \\d`))
    await picture(`clicked-${kind}`, own)
  }
  await own.context().close()
})

test('a file dropped on the editor is opened and not typed, and dropped text is typed', async () => {
  const own = await open('')
  await put(own, 'mine')
  const drop = what => own.evaluate(([name, text]) => {
    const dataTransfer = new DataTransfer()
    if (name) dataTransfer.items.add(new File([text], name))
    else dataTransfer.setData('text/plain', text)
    const line = document.querySelector('.cm-line')
    const { left: clientX, top: clientY } = line.getBoundingClientRect()
    line.dispatchEvent(new DragEvent('drop', { dataTransfer, clientX, clientY, bubbles: true, cancelable: true }))
  }, what)
  const content = () => own.locator('.cm-content').innerText()
  await drop(['', 'dropped '])
  assert.match(await content(), /dropped/)
  const before = await content()
  await drop(['flat.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n'])
  await own.waitForFunction(() => /flat.obj is open/.test(document.getElementById('said').textContent))
  await own.waitForTimeout(200)
  assert.equal(await content(), before)
  await drop(['other.hedge', '// other'])
  await own.waitForFunction(() => document.querySelector('.cm-content').innerText.includes('other'))
  await own.waitForTimeout(200)
  assert.equal(await content(), '// other')
  await own.locator('#files .file').first().click()
  assert.equal(await content(), before)
  await own.context().close()
})

test('a script that does not end is stopped, and the mesh is there again', async () => {
  const own = await open('')
  await own.locator('.cm-content').click()
  await own.keyboard.press('Control+a')
  await own.keyboard.insertText('script forever() { var n = 0 while n >= 0 { n = 1 - n } }\n')
  await own.waitForFunction(() => document.getElementById('script').value === 'forever')
  await own.locator('#run').click()
  await own.locator('#stop').click()
  await own.waitForFunction(() => /stopped/.test(document.getElementById('said').textContent))
  await own.waitForFunction(() => /162 vertices/.test(document.getElementById('counts').textContent))
  await own.context().close()
})

/** In a worker: lets an instance fail at an edit, or at a run, that names a trap. */
function failing() {
  const { instantiate } = WebAssembly
  WebAssembly.instantiate = async (...of) => {
    const { exports } = await instantiate(...of)
    let [at, length] = [0, 0]
    const take = wanted => at = exports.take(length = wanted)
    const unless = (pattern, answer) => () => {
      const message = new TextDecoder().decode(new Uint8Array(exports.memory.buffer, at, length))
      if (pattern.test(message)) throw new WebAssembly.RuntimeError('unreachable')
      return answer()
    }
    const { memory, lsp, ask } = exports
    const failing = { lsp: unless(/didChange.*trap/, lsp), ask: unless(/"run".*trap/, ask) }
    return { exports: { memory, take, ...failing } }
  }
}

test('where the language server or the workbench fails, a new one takes its place', async () => {
  const own = await open('', { serviceWorkers: 'block' }, context =>
    context.route('**/worker.js', async route => {
      const answer = await route.fetch()
      await route.fulfill({ response: answer, body: `(${failing})();${await answer.text()}` })
    }))
  await own.locator('.cm-content').click()
  await own.keyboard.press('Control+a')
  await own.keyboard.insertText('script trap() { print missing }\n')
  await own.waitForFunction(() => /missing/.test(document.getElementById('problems').textContent))
  await own.keyboard.press('Control+a')
  await own.keyboard.insertText('script trap() { print 1 }\n')
  await own.waitForFunction(() => document.getElementById('script').value === 'trap')
  await own.locator('#run').click()
  await own.waitForFunction(() => /workbench has failed.*as it was opened/.test(document.getElementById('said').textContent))
  await own.waitForFunction(() => /162 vertices/.test(document.getElementById('counts').textContent))
  await own.context().close()
})

test('programs use each other, and a name leads to the file that declares it', async () => {
  const own = await open('')
  const file = (name, body) => ({ name, mimeType: 'text/plain', buffer: Buffer.from(body) })
  const lift = 'op lift(f: face) { before { face f: v -h-> w =P=> v } after { keep f v.position = v.position + vec3(0, 1, 0) } }\n'
  await own.locator('#file').setInputFiles([
    file('part.hedge', lift),
    file('main.hedge', 'use "part.hedge"\nscript raise_all() { for f in faces { lift(f) } }\n'),
  ])
  await own.waitForFunction(() => document.getElementById('script').value === 'raise_all')
  await own.locator('#run').click()
  await own.waitForFunction(() => /lift\s*320/.test(document.getElementById('report').innerText))
  await own.waitForSelector('#problems', { state: 'hidden' })
  await own.locator('.cm-line').nth(1).getByText('lift').click()
  await own.keyboard.press('F12')
  await own.waitForFunction(() =>
    document.querySelector('#files [aria-current=true]').dataset.name === 'part.hedge')
  await own.keyboard.press('Control+a')
  await own.keyboard.insertText(lift.replace('op lift', 'op raise'))
  await own.locator('#files .file[data-name="main.hedge"]').click()
  await own.waitForFunction(() => /lift/.test(document.getElementById('problems').textContent))
  await picture('files', own)
  // What was changed is there the next time.
  await own.waitForTimeout(400)
  await own.reload()
  await own.waitForSelector('body[data-ready]')
  assert.equal(await own.locator('#files .file').count(), 2)
  assert.match(await own.locator('#files [aria-current=true]').innerText(), /main\.hedge/)
  await own.context().close()
})

test('once loaded, the page opens without a network, with all that it can do', async () => {
  const own = await open('')
  await own.evaluate(async () => {
    const { active } = await navigator.serviceWorker.ready
    if (active.state !== 'activated') {
      await new Promise(resolve => active.addEventListener('statechange', resolve))
    }
  })
  await own.context().setOffline(true)
  await server().pause()
  await own.reload()
  await own.waitForSelector('body[data-ready]')
  await own.selectOption('#shape', 'bunny')
  await own.waitForFunction(() => /1839 vertices/.test(document.getElementById('counts').textContent))
  await own.selectOption('#program', 'example:remesh.hedge')
  await own.waitForFunction(() => document.getElementById('script').value === 'remesh')
  await own.locator('#run').click()
  await own.waitForFunction(() => /1619 vertices/.test(document.getElementById('counts').textContent))
  await server().resume()
  await own.context().close()
})

test('attributes of all kinds of elements are shown in colour', async () => {
  const own = await open('')
  await own.locator('.cm-content').click()
  await own.keyboard.press('Control+a')
  const kinds = ['vertex', 'halfedge', 'edge', 'face']
  const many = { vertex: 'vertices', halfedge: 'halfedges', edge: 'edges', face: 'faces' }
  const sizes = { vertex: 162, halfedge: 960, edge: 480, face: 320 }
  let counted = 0
  await own.keyboard.insertText(kinds.map(kind => `attr ${kind}_value: ${kind} real = 0\n`).join('')
    + `script paint() {\n  var n = 0.0\n${kinds.map(kind =>
      `  for x in ${many[kind]} { n = n + 1 x.${kind}_value = n }\n`).join('')}}\n`)
  await own.waitForFunction(() => document.getElementById('script').value === 'paint')
  await own.locator('#run').click()
  for (const kind of kinds) {
    await own.selectOption('#attribute', `${kind}.${kind}_value`)
    await own.waitForFunction(name =>
      document.getElementById('legend').innerText.includes(name), `${kind}.${kind}_value`)
    // They are numbered through, from one kind to the next.
    const [least, most] = await Promise.all(
      ['least', 'most'].map(async id => Number(await own.locator(`#${id}`).innerText())))
    assert.equal(most - least + 1, sizes[kind])
    assert.equal(least, counted + 1)
    counted = most
    await picture(`colour-${kind}`, own)
  }
  // Few whole numbers and truth values have a colour each.
  await own.locator('.cm-content').click()
  await own.keyboard.press('Control+a')
  await own.keyboard.insertText('attr part: face int = 0\nattr cut: edge bool = false\n'
    + 'script mark() {\n  var n = 0\n'
    + '  for f in faces { n = n + 1 f.part = n mod 3 }\n'
    + '  for e in edges { e.cut = e.halfedge.face.part != e.halfedge.twin.face.part }\n}\n')
  await own.waitForFunction(() => document.getElementById('script').value === 'mark')
  await own.locator('#run').click()
  for (const [attribute, values] of [['face.part', '0 1 2'], ['edge.cut', 'true false']]) {
    await own.selectOption('#attribute', attribute)
    await own.waitForFunction(([name, values]) => {
      const words = document.getElementById('legend').innerText.split(/\s+/).filter(word => word)
      return words.join(' ') === `${name} ${values}`
    }, [attribute, values])
    await picture(`colour-${attribute}`, own)
    await own.emulateMedia({ colorScheme: 'dark' })
    await picture(`colour-${attribute}-dark`, own)
    await own.emulateMedia({ colorScheme: 'light' })
  }
  await own.context().close()
})

test('everything has a name, is reached by keys, and can be told apart', async () => {
  const source = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8')
  for (const colorScheme of ['light', 'dark']) {
    const own = await open('', { colorScheme, bypassCSP: true })
    await own.selectOption('#program', 'lesson:04_outside')
    await own.waitForSelector('#problems:not([hidden])')
    await own.locator('#lesson-check').click()
    await own.waitForSelector('#lesson-verdict .rejected')
    await own.evaluate(source)
    const { violations } = await own.evaluate(() => globalThis.axe.run(document))
    const told = violations.map(({ id, nodes }) => `${id}: ${nodes.map(node => node.html).join(' ')}`)
    assert.deepEqual(told, [])
    // The whole page by Tab: from the first to the last, each with a name. In the editor, Tab indents
    // and Escape lets it leave.
    await own.evaluate(() => {
      document.body.tabIndex = -1
      document.body.focus()
    })
    const reached = new Set()
    for (let at = 0; at < 90; at++) {
      await own.keyboard.press('Escape')
      await own.keyboard.press('Tab')
      const id = await own.evaluate(() => {
        const here = document.activeElement
        return here.id || here.tagName + here.className
      })
      if (id === 'BODY') break
      reached.add(id)
    }
    for (const id of ['program', 'learn', 'share', 'lesson-check', 'split-main', 'shape', 'CANVAS']) {
      assert.ok([...reached].some(it => it.startsWith(id)), `${id} of ${[...reached]}`)
    }
    await own.context().close()
  }
})

test('without a mouse: the mesh is turned, an operation is applied, parts are made wider', async () => {
  const own = await open('')
  await own.locator('#view canvas').focus()
  const before = await own.locator('#view').screenshot()
  await own.keyboard.press('ArrowLeft')
  await own.waitForTimeout(300)
  assert.notDeepEqual(await own.locator('#view').screenshot(), before)
  await own.locator('#element').focus()
  await own.keyboard.type('7')
  await own.keyboard.press('Enter')
  await own.waitForFunction(() => /applied at edge 7/.test(document.getElementById('said').textContent))
  const width = () => own.evaluate(() => document.getElementById('left').clientWidth)
  const narrow = await width()
  await own.locator('#split-main').focus()
  await own.keyboard.press('ArrowRight')
  assert.ok(await width() > narrow)
  await own.context().close()
})

test('by keys, the focus stays where something was done', async () => {
  const own = await open('')
  own.on('dialog', dialog => dialog.accept())
  const focused = () => own.evaluate(() => {
    const { id, dataset, className } = document.activeElement
    return id || dataset.name || className
  })
  const press = async of => {
    await of.focus()
    await own.keyboard.press('Enter')
    await own.waitForTimeout(300)
  }
  await put(own, 'mine')
  for (let at = 0; at < 2; at++) {
    await own.getByRole('button', { name: 'a new program' }).click()
    await own.keyboard.insertText('// new')
  }
  const files = own.locator('#files .file')
  for (const at of [0, 2]) {
    await press(files.nth(at))
    assert.equal(await focused(), ['flip.hedge', 'mine.hedge', 'mine2.hedge'][at])
  }
  await press(own.locator('#files .close').first())
  assert.equal(await focused(), 'mine.hedge')
  await press(own.locator('#files .close').last())
  assert.equal(await focused(), 'mine.hedge')
  await own.selectOption('#program', 'example:flip.hedge')
  await own.waitForFunction(() => document.getElementById('op').value === 'flip')
  await own.locator('#element').fill('3')
  await press(own.locator('#element'))
  await own.waitForFunction(() => /applied at edge 3/.test(document.getElementById('said').textContent))
  for (const [id, other] of [['undo', 'redo'], ['redo', 'undo']]) {
    await press(own.locator(`#${id}`))
    await own.waitForFunction(id => document.getElementById(id).disabled, id)
    assert.equal(await focused(), other)
  }
  await own.context().close()
})

test('who comes into the editor by keys is told how it is left', async () => {
  const own = await open('')
  const hint = own.locator('#editor-keys')
  await own.locator('.cm-content').click()
  assert.ok(await hint.isHidden())
  await own.keyboard.press('Tab')
  assert.match(await hint.innerText(), /Escape, then Tab/)
  assert.equal(await own.locator('.cm-content').getAttribute('aria-describedby'), 'editor-keys')
  await picture('editor-keys', own)
  await own.keyboard.press('Escape')
  await own.keyboard.press('Tab')
  assert.ok(!await own.evaluate(() => document.activeElement.closest('.cm-content')))
  assert.ok(await hint.isHidden())
  await own.context().close()
})

test('on a phone an edge is touched and flips', async () => {
  const phone = await open('', { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true })
  await phone.locator('#view').scrollIntoViewIfNeeded()
  const box = await phone.locator('#view').boundingBox()
  await phone.touchscreen.tap(box.x + box.width / 2 + 4, box.y + box.height / 2 + 6)
  await phone.waitForFunction(() => /applied|refuses/.test(document.getElementById('said').textContent))
  await picture('phone-touched', phone)
  await phone.context().close()
})

test('dark, and narrow as a phone', async () => {
  const dark = await open('', { colorScheme: 'dark' })
  await dark.waitForSelector('#pane svg')
  await picture('dark', dark)
  await dark.context().close()
  const phone = await open('', { viewport: { width: 390, height: 844 } })
  await phone.waitForSelector('#pane svg')
  await picture('phone', phone)
  const wide = await phone.evaluate(() => document.documentElement.scrollWidth)
  assert.ok(wide <= 390, `${wide} pixels wide`)
  await phone.context().close()
})

test('nothing is asked of anybody else, and nothing fails', () => {
  assert.deepEqual(faults, [])
})
