// A headless browser, and the page in it. `SCREENSHOTS=folder` keeps pictures, `CHROMIUM` names the
// browser.

import { existsSync, mkdirSync } from 'node:fs'
import { dirname, join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { chromium } from 'playwright-core'
import { serve } from './serve.js'

export const here = dirname(fileURLToPath(import.meta.url))
const pictures = process.env.SCREENSHOTS
const known = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome']
const executablePath = process.env.CHROMIUM || known.find(existsSync)

let served, browser
/** What went wrong in any page. */
export const faults = []

export async function start() {
  served = await serve(join(here, '../dist'))
  browser = await chromium.launch({
    executablePath, args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  })
}

export async function end() {
  await browser?.close()
  await served?.end()
}

export const server = () => served

/** The page, ready; `prepare` may change its context before. */
export async function open(fragment, options = {}, prepare = async () => {}) {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, ...options })
  await prepare(context)
  const opened = await context.newPage()
  opened.on('pageerror', error => faults.push(String(error)))
  opened.on('console', message => message.type() === 'error' && faults.push(message.text()))
  await opened.goto(served.address + fragment)
  await opened.waitForSelector('body[data-ready]', { timeout: 60_000 })
  return opened
}

/** Keeps a picture of a page. */
export async function keep(name, of) {
  if (!pictures) return
  mkdirSync(pictures, { recursive: true })
  await of.waitForTimeout(300)
  await of.screenshot({ path: join(pictures, `${name}.png`) })
}
