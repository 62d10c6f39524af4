// What is unusual, in a headless browser: meshes of any size, programs with errors, long names, narrow
// windows. `node --test test/odd.js`.

import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { end, faults, keep, open, start } from './browser.js'

before(start, { timeout: 120_000 })
after(end)

test('a mesh of any size is seen, wherever it lies', async () => {
  const own = await open('')
  const corners = [[-1, -1, -1], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
  let usual
  for (const [name, size, away] of [
    ['usual', 1, 0], ['huge', 1e160, 0], ['large', 1e18, 0], ['small', 1e-30, 0], ['far', 1, 1e6], ['again', 1, 0],
  ]) {
    const lines = corners.map(at => `v ${at.map(part => part * size + away).join(' ')}\n`).join('')
    await own.selectOption('#shape', 'cube')
    await own.waitForFunction(() => /8 vertices/.test(document.getElementById('counts').textContent))
    await own.locator('#file').setInputFiles({
      name: `${name}.obj`, mimeType: 'text/plain',
      buffer: Buffer.from(`${lines}f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n`),
    })
    await own.waitForFunction(name =>
      document.getElementById('said').textContent === `${name}.obj is open`, name)
    let shot
    for (let wait = 0; wait < 20 && !(usual && shot?.equals(usual)); wait++) {
      await own.waitForTimeout(200)
      const before = shot
      shot = await own.locator('#view').screenshot()
      if (!usual && before?.equals(shot) && wait > 3) usual = shot
    }
    await keep(`size-${name}`, own)
    assert.ok(usual?.equals(shot), `${name} looks as the usual one`)
  }
  await own.context().close()
})

test('an old program says so, and no element has the number -1', async () => {
  const own = await open('')
  const write = async program => {
    await own.locator('.cm-content').click()
    await own.keyboard.press('Control+a')
    await own.keyboard.insertText(program)
  }
  for (const at of ['-1', '1.5', '5000000000']) {
    await own.locator('#element').fill(at)
    await own.locator('#apply').click()
    await own.waitForFunction(at =>
      document.getElementById('said').textContent.includes(`${at} is not the number of any edge`), at)
  }
  await own.locator('#file').setInputFiles({
    name: 'own.HEDGE', mimeType: 'text/plain', buffer: Buffer.from('script none() { }\n'),
  })
  await own.waitForFunction(() => document.getElementById('script').value === 'none')
  const name = 'n'.repeat(200)
  await write(`script ${name}() { print "old" }\n`)
  await own.waitForFunction(name => document.getElementById('script').value === name, name)
  assert.ok(await own.locator('#stale').isHidden())
  await write(`script ${name}() { print "new" `)
  await own.locator('#stale').waitFor({ state: 'visible' })
  await own.locator('#run').click()
  await own.waitForFunction(() => /old/.test(document.getElementById('report').textContent))
  await keep('stale', own)
  // However the divider lies, and however narrow the window is, nothing is cut off.
  const divider = await own.locator('#split-main').boundingBox()
  await own.mouse.move(divider.x + 2, divider.y + 200)
  await own.mouse.down()
  await own.mouse.move(1435, divider.y + 200)
  await own.mouse.up()
  await own.setViewportSize({ width: 1000, height: 600 })
  await keep('divided', own)
  const cut = await own.evaluate(() => {
    const { right } = document.getElementById('right').getBoundingClientRect()
    const parts = [...document.querySelectorAll('#right .bar:not([hidden]) :is(select, button, input:not([type=file])), #said, #said *, #counts')]
    return parts.filter(part => part.getBoundingClientRect().right > right || part.scrollWidth > part.clientWidth + 30)
      .map(part => part.id || part.tagName)
  })
  assert.deepEqual(cut, [])
  await own.context().close()
})

test('nothing fails', () => {
  assert.deepEqual(faults, [])
})
