// How fast the page is, and how large: `node test/measure.js [ADDRESS]`. With the address of
// `hedgerow play` the machine behind it is measured, too. Times are wall-clock times of the machine as
// it is; the least of several.

import { readFileSync, readdirSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { dirname, join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { brotliCompressSync, constants } from 'node:zlib'
import { chromium } from 'playwright-core'
import { serve } from './serve.js'

const here = dirname(fileURLToPath(import.meta.url))
const dist = join(here, '../dist')
const TIMES = 5

const rows = []
const tell = (what, value, unit, target = '') => {
  rows.push([what, value, unit, target])
  console.log(`${what}: ${value} ${unit}${target && ` (target ${target})`}`)
}

// What goes over the wire: all files of the page, at the qualities that servers use.
for (const quality of [9, 11]) {
  let all = 0
  for (const name of readdirSync(dist)) {
    const options = { params: {
      [constants.BROTLI_PARAM_QUALITY]: quality, [constants.BROTLI_PARAM_LGWIN]: 24,
    } }
    all += brotliCompressSync(readFileSync(join(dist, name)), options).length
  }
  tell(`transfer, brotli ${quality}`, (all / 1e6).toFixed(2), 'MB', '1.6')
}

const given = process.argv[2]
const server = given ? { address: given, end() {} } : await serve(dist)
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM || '/usr/bin/chromium',
  args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
})

/** The processor time of the browser so far, in seconds, where /proc tells it. */
function busy() {
  let processes
  try {
    processes = readdirSync('/proc').filter(name => /^\d+$/.test(name)).flatMap(id => {
      try {
        const fields = readFileSync(`/proc/${id}/stat`, 'utf8').split(') ').at(-1).split(' ')
        return [{ id: Number(id), parent: Number(fields[1]), time: (Number(fields[11]) + Number(fields[12])) / 100 }]
      } catch {
        return []
      }
    })
  } catch {
    return NaN
  }
  const inside = new Set([process.pid])
  for (let grown = true; grown;) {
    const more = processes.filter(({ id, parent }) => inside.has(parent) && !inside.has(id))
    more.forEach(({ id }) => inside.add(id))
    grown = more.length > 0
  }
  const own = processes.filter(({ id }) => inside.has(id) && id !== process.pid)
  return own.reduce((sum, { time }) => sum + time, 0)
}

async function open() {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 } })
  const page = await context.newPage()
  const started = performance.now()
  await page.goto(server.address)
  await page.waitForSelector('body[data-ready]')
  return [page, performance.now() - started]
}

const least = async measured => {
  const all = []
  for (let at = 0; at < TIMES; at++) all.push(await measured())
  return Math.min(...all)
}

tell('page ready', Math.round(await least(async () => {
  const [page, time] = await open()
  await page.context().close()
  return time
})), 'ms', '2000')

const [page] = await open()
const text = () => page.locator('#said').innerText()

// From a keystroke that breaks the program to the diagnostic, and back.
await page.selectOption('#program', 'example:flip.hedge')
await page.waitForSelector('#pane svg')
await page.evaluate(() => {
  const problems = document.getElementById('problems')
  document.addEventListener('keydown', () => (globalThis.typed = performance.now()), true)
  new MutationObserver(() => {
    if (!problems.hidden) globalThis.told ??= performance.now() - globalThis.typed
  }).observe(problems, { childList: true, attributes: true })
})
await page.locator('.cm-line', { hasText: 'edge e: a | d' }).first().click()
await page.keyboard.press('End')
const keystroke = await least(async () => {
  await page.evaluate(() => (globalThis.told = undefined))
  await page.keyboard.press('x')
  await page.waitForFunction(() => globalThis.told !== undefined)
  await page.keyboard.press('Backspace')
  await page.waitForSelector('#problems', { state: 'hidden' })
  return page.evaluate(() => globalThis.told)
})
tell('first diagnostic after a keystroke', Math.round(keystroke), 'ms', '300')

await page.selectOption('#shape', 'bunny')
await page.selectOption('#program', 'example:remesh.hedge')
await page.waitForFunction(() => document.getElementById('script').value === 'remesh')
tell('bunny remeshed and shown', await least(async () => {
  await page.selectOption('#shape', 'bunny')
  await page.waitForFunction(() => /1839 vertices/.test(document.getElementById('counts').textContent))
  await page.locator('#run').click()
  await page.waitForFunction(() => /remesh: /.test(document.getElementById('said').textContent))
  return Number(/([\d.]+) seconds/.exec(await text())[1])
}), 's', '0.3')

/** A wavy torus of so many triangles, as OBJ. */
function torus(triangles) {
  const wide = Math.round(Math.sqrt(triangles))
  const high = Math.round(triangles / 2 / wide)
  const lines = []
  for (let v = 0; v < high; v++) {
    for (let u = 0; u < wide; u++) {
      const [a, b] = [2 * Math.PI * u / wide, 2 * Math.PI * v / high]
      const r = 0.4 + 0.03 * Math.sin(9 * a) * Math.cos(7 * b)
      const away = 1 + r * Math.cos(b)
      lines.push(`v ${(away * Math.cos(a)).toFixed(6)} ${(r * Math.sin(b)).toFixed(6)} ${(away * Math.sin(a)).toFixed(6)}`)
    }
  }
  const at = (u, v) => (v % high) * wide + u % wide + 1
  for (let v = 0; v < high; v++) {
    for (let u = 0; u < wide; u++) {
      lines.push(`f ${at(u, v)} ${at(u, v + 1)} ${at(u + 1, v)}`, `f ${at(u + 1, v)} ${at(u, v + 1)} ${at(u + 1, v + 1)}`)
    }
  }
  return Buffer.from(lines.join('\n'))
}

const machine = given ? 'machine behind it' : 'WebAssembly'
for (const [triangles, target] of [[100_000, '15 in software'], [1_000_000, '']]) {
  const buffer = torus(triangles)
  const started = performance.now()
  if (buffer.length < 50e6) {
    await page.locator('#file').setInputFiles({ name: 'torus.obj', mimeType: 'text/plain', buffer })
  } else {
    writeFileSync(join(tmpdir(), 'torus.obj'), buffer)
    await page.locator('#file').setInputFiles(join(tmpdir(), 'torus.obj'))
  }
  await page.waitForFunction(() => /torus.obj is open/.test(document.getElementById('said').textContent), null, { timeout: 120_000 })
  tell(`${triangles} triangles opened, ${machine}`, ((performance.now() - started) / 1000).toFixed(2), 's')
  const box = await page.locator('#view').boundingBox()
  const middle = [box.x + box.width / 2, box.y + box.height / 2]
  // The mesh is turned by the pointer for some seconds; pictures are counted when the card is done.
  await page.evaluate(() => {
    const canvas = document.querySelector('#view canvas')
    const context = canvas.getContext('webgl2')
    globalThis.pictures = []
    const draw = context.drawElements.bind(context)
    let isDrawn = false
    context.drawElements = (...of) => { isDrawn = true; return draw(...of) }
    const pixel = new Uint8Array(4)
    const count = now => {
      if (isDrawn) {
        context.readPixels(0, 0, 1, 1, context.RGBA, context.UNSIGNED_BYTE, pixel)
        globalThis.pictures.push(performance.now())
      }
      isDrawn = false
      requestAnimationFrame(count)
    }
    requestAnimationFrame(count)
  })
  await page.mouse.move(...middle)
  await page.mouse.down()
  const turn = async seconds => {
    const until = performance.now() + 1000 * seconds
    for (let at = 0; performance.now() < until; at++) {
      await page.mouse.move(middle[0] + 120 * Math.sin(at / 9), middle[1] + 60 * Math.sin(at / 13))
      await page.waitForTimeout(8)
    }
  }
  // What is too slow has been made coarser after some pictures.
  await turn(3)
  await page.evaluate(() => (globalThis.pictures.length = 0))
  const before = busy()
  await turn(4)
  const pictures = await page.evaluate(() => globalThis.pictures)
  const time = busy() - before
  await page.mouse.up()
  const rate = list => list.length < 2 ? 0 : 1000 * (list.length - 1) / (list.at(-1) - list[0])
  tell(`${triangles} triangles turned`, rate(pictures).toFixed(1), 'pictures a second', target)
  tell(`${triangles} triangles turned, processor time of a picture`, (1000 * time / pictures.length).toFixed(0), 'ms')
  const memory = await page.evaluate(() => performance.memory?.usedJSHeapSize ?? 0)
  tell(`${triangles} triangles, memory of the page's scripts`, (memory / 1e6).toFixed(0), 'MB')
  if (triangles === 100_000) await measureSteps()
}

/** How long it takes to step back through a script, until the page shows it. */
async function measureSteps() {
  await page.locator('#run').click()
  await page.waitForFunction(() => /remesh: /.test(document.getElementById('said').textContent), null, { timeout: 120_000 })
  const times = await page.evaluate(async times => {
    const told = document.getElementById('step-count')
    const frame = () => new Promise(requestAnimationFrame)
    const all = []
    for (let at = 0; at < 2 * times; at++) {
      const [started, before] = [performance.now(), told.textContent]
      document.getElementById('step-back').click()
      while (told.textContent === before) await new Promise(then => setTimeout(then))
      await frame()
      await frame()
      all.push(performance.now() - started)
      await new Promise(then => setTimeout(then, 500))
    }
    return all
  }, TIMES)
  tell('a step back through a script on it', Math.round(Math.min(...times)), 'ms', '50')
}

await browser.close()
await server.end()
console.log(`\n| what | measured | target |\n| --- | --- | --- |`)
for (const [what, value, unit, target] of rows) console.log(`| ${what} | ${value} ${unit} | ${target} |`)
