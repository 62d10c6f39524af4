// The page of `hedgerow play` in a headless browser: the files of a folder are listed, opened, used and
// saved, and the machine behind it does the work. `node --test test/play.js`; HEDGEROW names the
// program, else that of the tests is taken.

import assert from 'node:assert/strict'
import { spawn } from 'node:child_process'
import { copyFileSync, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { dirname, join } from 'node:path'
import { test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { chromium } from 'playwright-core'

const here = dirname(fileURLToPath(import.meta.url))
const program = process.env.HEDGEROW || join(here, '../../target/debug/hedgerow')
const known = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome']
const executablePath = process.env.CHROMIUM || known.find(existsSync)
const skip = !existsSync(program) && !process.env.CI && `there is no ${program}`

const LIFT = 'op lift(f: face) { before { face f: v -h-> w =P=> v } after { keep f v.position = v.position + vec3(0, 1, 0) } }\n'

test('the files of a folder are listed, opened, used and saved', { skip, timeout: 120_000 }, async () => {
  const folder = mkdtempSync(join(tmpdir(), 'hedgerow-'))
  writeFileSync(join(folder, 'part.hedge'), LIFT)
  writeFileSync(join(folder, 'main.hedge'), 'use "part.hedge"\nscript raise() { for f in faces { lift(f) } }\n')
  copyFileSync(join(here, '../../examples/meshes/bunny.obj'), join(folder, 'hare.obj'))
  const child = spawn(program, ['play', '--no-browser', join(folder, 'main.hedge'), join(folder, 'hare.obj')])
  const browser = await chromium.launch({
    executablePath, args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  })
  try {
    const address = await new Promise((told, failed) => {
      child.stdout.once('data', text => told(String(text).trim()))
      child.once('exit', () => failed(new Error('hedgerow play has ended: was it built with its page?')))
    })
    const page = await browser.newPage({ viewport: { width: 1440, height: 900 } })
    const faults = []
    page.on('pageerror', error => faults.push(String(error)))
    page.on('console', message => message.type() === 'error' && faults.push(message.text()))
    const said = (id, pattern) => page.waitForFunction(
      ([id, source]) => new RegExp(source).test(document.getElementById(id).innerText), [id, pattern.source])
    await page.goto(address)
    await page.waitForSelector('body[data-ready]')
    await said('counts', /1839 vertices/)
    const listed = await page.locator('#program optgroup[label=folder] option').allInnerTexts()
    assert.deepEqual(listed, ['main.hedge', 'part.hedge'])
    assert.deepEqual(await page.locator('#shape optgroup[label=folder] option').allInnerTexts(), ['hare.obj'])
    // The server finds what the program uses, too: a name leads there.
    assert.ok(await page.locator('#problems').isHidden())
    await page.locator('#run').click()
    await said('report', /lift\s+3674/)
    // Back through the script, by the machine behind the page.
    await page.locator('#step-back').click()
    await said('step-count', /^3673 of 3674/)
    await page.locator('#step').fill('0')
    await said('step-count', /^0 of 3674/)
    await page.locator('.cm-content').click()
    await page.keyboard.press('Control+End')
    await page.keyboard.insertText('// mine\n')
    await page.keyboard.press('Control+s')
    await said('shared', /saved: main.hedge/)
    assert.match(readFileSync(join(folder, 'main.hedge'), 'utf8'), /raise[^]*\/\/ mine\n$/)
    // What somebody else has changed is not overwritten.
    writeFileSync(join(folder, 'main.hedge'), '// theirs\n')
    await page.keyboard.insertText('// more\n')
    await page.keyboard.press('Control+s')
    await said('said', /changed elsewhere/)
    assert.equal(readFileSync(join(folder, 'main.hedge'), 'utf8'), '// theirs\n')
    await page.selectOption('#program', 'folder:part.hedge')
    await page.waitForFunction(() => document.getElementById('op').value === 'lift')
    await page.selectOption('#shape', 'cube')
    await said('counts', /8 vertices/)
    await page.selectOption('#shape', 'folder:hare.obj')
    await said('counts', /1839 vertices/)
    // The page again, and a second one beside it: as on first load.
    const second = await browser.newPage()
    await second.goto(address)
    // What is not saved is asked about.
    const asked = []
    page.on('dialog', dialog => asked.push(dialog.type()) && dialog.accept())
    await page.reload()
    assert.deepEqual(asked, ['beforeunload'])
    for (const again of [page, second]) {
      await again.waitForSelector('body[data-ready]')
      await again.selectOption('#program', 'folder:part.hedge')
      await again.waitForFunction(() => /proved/.test(document.getElementById('pane').innerText))
    }
    assert.deepEqual(faults, [])
  } finally {
    await browser.close()
    child.kill()
    rmSync(folder, { recursive: true, force: true })
  }
})
