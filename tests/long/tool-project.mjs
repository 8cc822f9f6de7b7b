// SPDX-License-Identifier: GPL-3.0-or-later
// Projects of other tools that use the packed package, and the actions of a reader on the figure in their pages.
import assert from 'node:assert/strict'
import { execFileSync, spawn } from 'node:child_process'
import { mkdirSync, mkdtempSync, readdirSync, rmSync, writeFileSync } from 'node:fs'
import { createServer as createHttpServer } from 'node:http'
import { createServer } from 'node:net'
import { tmpdir } from 'node:os'
import { dirname, join } from 'node:path'
import { chromium } from '@playwright/test'
import sirv from 'sirv'
import { tarball } from '../pack/project.mjs'

/** A folder for each tool. */
export class ToolProjects {
  #folder = mkdtempSync(join(tmpdir(), 'circle-voronoi-tools-'))

  /** A project with `files` (texts by their paths) into which `packages` (`name@version`) and the package are installed. */
  create(name, packages, files) {
    const folder = join(this.#folder, name)
    const all = { 'package.json': JSON.stringify({ private: true, type: 'module' }), ...files }
    for (const [path, text] of Object.entries(all)) this.write(folder, path, text)
    const install = ['install', '--silent', '--no-audit', '--no-fund', '--no-package-lock', '--legacy-peer-deps']
    run(folder, 'npm', [...install, tarball(), ...packages])
    return folder
  }

  write(folder, path, text) {
    mkdirSync(dirname(join(folder, path)), { recursive: true })
    writeFileSync(join(folder, path), text)
  }

  /** Removes the projects, some of which take a gigabyte. */
  clear() {
    for (const name of readdirSync(this.#folder)) rmSync(join(this.#folder, name), { recursive: true, force: true })
  }

  remove() {
    rmSync(this.#folder, { recursive: true, force: true })
  }
}

/** The environment of the tools: no questions, no colors, no telemetry. */
const ENV = {
  ...process.env,
  CI: 'true',
  NO_COLOR: '1',
  FORCE_COLOR: '0',
  NODE_ENV: undefined,
  NODE_TEST_CONTEXT: undefined,
  ASTRO_TELEMETRY_DISABLED: '1',
  NEXT_TELEMETRY_DISABLED: '1',
  NUXT_TELEMETRY_DISABLED: '1',
  NG_CLI_ANALYTICS: 'false',
}

/** Returns a program's output. Programs of the project's own packages are found by name. */
export function run(folder, program, args) {
  const PATH = `${join(folder, 'node_modules/.bin')}:${process.env.PATH}`
  try {
    return execFileSync(program, args, { cwd: folder, env: { ...ENV, PATH }, encoding: 'utf8', stdio: 'pipe' })
  } catch ({ message, stdout, stderr }) {
    throw new Error(`${message}\n${stdout}\n${stderr}`)
  }
}

/** Serves a folder like a plain file server while `use` runs. `single` serves one page at all addresses. */
export async function withFiles(folder, use, { single = false } = {}) {
  const files = sirv(folder, { dev: true, extensions: ['html'], single })
  const server = createHttpServer((request, response) => files(request, response, () => response.writeHead(404).end()))
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve))
  try {
    return await use(`http://127.0.0.1:${server.address().port}/`)
  } finally {
    server.closeAllConnections()
    server.close()
  }
}

/** Runs a tool's server while `use` runs. `args` maps a port to its arguments. */
export async function withServer(folder, program, args, use) {
  const port = await freePort()
  const PATH = `${join(folder, 'node_modules/.bin')}:${process.env.PATH}`
  const server = spawn(program, args(port), {
    cwd: folder,
    env: { ...ENV, PATH },
    // Its children can be ended together with it.
    detached: true,
    stdio: ['ignore', 'pipe', 'pipe'],
  })
  let output = ''
  for (const stream of [server.stdout, server.stderr]) {
    stream.setEncoding('utf8').on('data', (text) => {
      output += text
    })
  }
  try {
    const address = `http://localhost:${port}/`
    await answering(address, server, () => output)
    return await use(address)
  } catch (error) {
    throw new Error(`${error.message}\n${output}`, { cause: error })
  } finally {
    try {
      process.kill(-server.pid)
    } catch {
      // The process has ended already.
    }
  }
}

async function freePort() {
  const server = createServer()
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve))
  const { port } = server.address()
  await new Promise((resolve) => server.close(resolve))
  return port
}

async function answering(address, server, output) {
  for (;;) {
    if (server.exitCode !== null) throw new Error(`The server has ended.\n${output()}`)
    const isThere = await fetch(address).then(
      () => true,
      () => false,
    )
    if (isThere) return
    await new Promise((resolve) => setTimeout(resolve, 100))
  }
}

export const CIRCLES = '[[2,2,0.5],[6,3,1],[4,6,0.7]]'
export const REGION = 'POLYGON ((0 0, 9 0, 9 8, 0 8))'
/** The figure in all recipes. */
export const FIGURE = `<circle-voronoi circles="${CIRCLES}" region="${REGION}"></circle-voronoi>`

let browser
export async function launchBrowser() {
  browser = await chromium.launch({
    executablePath: process.env.CHROMIUM_PATH ?? '/usr/bin/chromium',
    args: ['--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run'],
  })
}
export const closeBrowser = () => browser.close()

/**
 * Opens a page with the figure of all recipes. Expects that the figure is drawn inside its region, that a drag moves a
 * circle, and that nothing is missing. `isTouch` drags by finger, `hasKeys` also tests an arrow key, and `afterwards`
 * runs further checks.
 */
export async function useFigure(address, options = {}) {
  try {
    await useFigureOnce(address, options)
  } catch (error) {
    // Vite's servers reload a page once they have found its imports.
    if (!error.message.includes('Execution context was destroyed')) throw error
    await useFigureOnce(address, options)
  }
}

async function useFigureOnce(address, options) {
  const { viewport = { width: 1000, height: 700 }, isTouch = false, hasKeys = false, afterwards } = options
  const context = await browser.newContext({ viewport, hasTouch: isTouch })
  const page = await context.newPage()
  const problems = []
  page.on('pageerror', ({ message }) => problems.push(message))
  page.on('console', (message) => message.type() === 'error' && problems.push(message.text()))
  page.on('response', (response) => response.status() >= 400 && problems.push(`${response.status()} ${response.url()}`))
  try {
    await page.goto(address)
    const figure = page.locator('circle-voronoi').first()
    await settled(figure)
    const [x, y] = await placeOfCircle(figure)
    const drag = isTouch ? dragByFinger : dragByMouse
    await moves(figure, () => drag(page, [x, y], [x + 60, y + 10]))
    if (hasKeys) await moves(figure, () => page.keyboard.press('ArrowRight'))
    await afterwards?.(page)
    // Browsers request icons that a site lacks, themes fetch fonts from other sites, also without a network, and Slidev
    // reports a fault of its own tooltips (FloatingVue).
    assert.deepEqual(
      problems.filter((problem) => !/favicon|404 \(Not Found\)$|ERR_NAME_NOT_RESOLVED|FloatingVue/.test(problem)),
      [],
    )
  } catch (error) {
    const html = await page.content().catch(() => '')
    throw new Error(`${error.message}\n${problems.join('\n')}\n${html.slice(0, 3000)}`, { cause: error })
  } finally {
    await context.close()
  }
}

/** Expects that an action moves circle 0 to the right. */
async function moves(figure, act) {
  const x = () => figure.evaluate((element) => element.circles[0])
  const before = await x()
  await act()
  for (const end = Date.now() + 20_000; ; ) {
    const now = await x()
    if (now > before) return
    if (Date.now() > end) throw new Error(`Circle 0 is at ${now}, and was at ${before}.`)
    await new Promise((resolve) => setTimeout(resolve, 50))
  }
}

/** Waits for the figure. Expects that its cells are clipped to its region and that its layers use all modules. */
async function settled(figure) {
  await figure.waitFor({ state: 'attached' })
  await figure.scrollIntoViewIfNeeded()
  return figure.evaluate(async (element) => {
    await customElements.whenDefined('circle-voronoi')
    await element.ready
    element.layers = { power: true }
    await element.updateComplete
    const text = await element.toSVG()
    if (!/clip-path/.test(text))
      throw new Error(`Nothing is cut to the region: ${element.shadowRoot.querySelector('.problem').textContent}`)
    element.layers = {}
    await element.updateComplete
  })
}

/** The position of circle 0's center on the page, at any scale of the figure. */
async function placeOfCircle(figure) {
  return figure.evaluate(async (element) => {
    const [middle, span] = [{ x: 4.5, y: 4 }, 10]
    element.view = { ...middle, span }
    await element.updateComplete
    const { left, top, width, height } = element.shadowRoot.querySelector('.figure').getBoundingClientRect()
    const scale = Math.min(width, height) / span
    const [x, y] = element.circles
    return [left + width / 2 + (x - middle.x) * scale, top + height / 2 - (y - middle.y) * scale]
  })
}

async function dragByMouse(page, from, to) {
  await page.mouse.move(...from)
  await page.mouse.down()
  await page.mouse.move(...to, { steps: 6 })
  await page.mouse.up()
}

async function dragByFinger(page, [x, y], [toX, toY]) {
  const session = await page.context().newCDPSession(page)
  const touch = (type, touchPoints) => session.send('Input.dispatchTouchEvent', { type, touchPoints })
  await touch('touchStart', [{ x, y }])
  for (let k = 1; k <= 6; k++) await touch('touchMove', [{ x: x + ((toX - x) * k) / 6, y: y + ((toY - y) * k) / 6 }])
  await touch('touchEnd', [])
}
