// SPDX-License-Identifier: GPL-3.0-or-later
import { type ChildProcess, spawn } from 'node:child_process'
import { existsSync, mkdtempSync, readdirSync, rmSync } from 'node:fs'
import { createServer } from 'node:net'
import { tmpdir } from 'node:os'
import type { Hands } from '../e2e/monkey.ts'
import { type Engine, inWindow, type Keys, keysOf } from './engine.ts'

/** The protocol's names of keys that are not letters. */
const KEYS: Readonly<Record<string, string>> = {
  Backspace: '\uE003',
  Tab: '\uE004',
  Enter: '\uE007',
  Shift: '\uE008',
  Control: '\uE009',
  Alt: '\uE00A',
  Escape: '\uE00C',
  ArrowLeft: '\uE012',
  ArrowUp: '\uE013',
  ArrowRight: '\uE014',
  ArrowDown: '\uE015',
  Delete: '\uE017',
}
const ELEMENT = 'element-6066-11e4-a52e-4f735466cecf'

/** Opens WebKitGTK, the engine of Safari, over WebDriver. */
export async function openWebKit(): Promise<Engine> {
  const home = mkdtempSync(`${tmpdir()}/webkit-`)
  const display = spawn('Xvfb', ['-displayfd', '3', '-screen', '0', '1400x1000x24', '-nolisten', 'tcp'], {
    stdio: ['ignore', 'ignore', 'ignore', 'pipe'],
  })
  // Also runs if a test is stopped by its time limit.
  process.once('exit', () => display.kill())
  const number = await firstLine(display)
  const port = await freePort()
  const driver = spawn('WebKitWebDriver', [`--port=${port}`], {
    stdio: 'ignore',
    env: {
      ...process.env,
      HOME: home,
      XDG_RUNTIME_DIR: home,
      DISPLAY: `:${number}`,
      LIBGL_ALWAYS_SOFTWARE: '1',
      WEBKIT_DISABLE_COMPOSITING_MODE: '1',
      // Its sandbox needs rights that containers do not give.
      WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS: '1',
    },
  })
  process.once('exit', () => driver.kill())

  const send = async (method: string, path: string, body?: object): Promise<never> => {
    const response = await fetch(`http://127.0.0.1:${port}${path}`, {
      method,
      ...(body && { body: JSON.stringify(body) }),
    })
    const { value } = (await response.json()) as { value: never }
    if (!response.ok) {
      const { error, message } = value as { error: string; message: string }
      throw new Error(`WebKit: ${error}: ${message}`)
    }
    return value
  }
  const close = async (session?: string) => {
    if (session !== undefined) await send('DELETE', `/session/${session}`)
    for (const child of [driver, display]) await ended(child)
    rmSync(home, { recursive: true, force: true })
  }

  try {
    await listening(port)
    const browserOptions = { binary: miniBrowser(), args: ['--automation'] }
    const alwaysMatch = { 'webkitgtk:browserOptions': browserOptions }
    const { sessionId } = await send('POST', '/session', { capabilities: { alwaysMatch } })
    const session = `/session/${sessionId}`
    const post = (path: string, body: object) => send('POST', `${session}/${path}`, body)
    // The test's own time limit is enough.
    await post('timeouts', { script: null })
    await post('window/rect', { x: 0, y: 0, width: 1280, height: 900 })

    const evaluate: Engine['evaluate'] = async (call, ...args) => {
      const script = `
        const args = [...arguments]
        const done = args.pop()
        Promise.resolve().then(() => (${call})(...args))
          .then((result) => done({ result }), (error) => done({ error: String(error) }))`
      const { result, error }: { result: never; error?: string } = await post('execute/async', { script, args })
      if (error !== undefined) throw new Error(error)
      return result
    }
    const act = (type: string, actions: readonly object[], parameters = {}) =>
      post('actions', { actions: [{ type, id: type, actions, ...parameters }] })
    const mouse = (...actions: readonly object[]) => act('pointer', actions, { parameters: { pointerType: 'mouse' } })
    const valuesOf = (keys: Keys) => keysOf(keys).map((key) => KEYS[key] ?? key)
    const press = async (keys: Keys) => {
      const values = valuesOf(keys)
      await act('key', [
        ...values.map((value) => ({ type: 'keyDown', value })),
        ...values.reverse().map((value) => ({ type: 'keyUp', value })),
      ])
    }
    const BUTTONS = { left: 0, middle: 1, right: 2 }
    let at = { x: 0, y: 0 }
    const moveTo = async (x: number, y: number) => {
      const [nearX, nearY] = await evaluate(inWindow, [x, y] as const)
      at = { x: nearX, y: nearY }
      return { type: 'pointerMove', duration: 16, ...at }
    }
    const click = [
      { type: 'pointerDown', button: 0 },
      { type: 'pointerUp', button: 0 },
    ]
    const hands: Hands = {
      evaluate,
      mouse: {
        move: async (x, y) => mouse(await moveTo(x, y)),
        down: ({ button = 'left' } = {}) => mouse({ type: 'pointerDown', button: BUTTONS[button] }),
        up: ({ button = 'left' } = {}) => mouse({ type: 'pointerUp', button: BUTTONS[button] }),
        click: async (x, y, { clickCount = 1 } = {}) =>
          mouse(await moveTo(x, y), ...Array.from({ length: clickCount }, () => click).flat()),
        wheel: (deltaX, deltaY) => act('wheel', [{ type: 'scroll', ...at, deltaX, deltaY }]),
      },
      keyboard: {
        down: (key) => act('key', [{ type: 'keyDown', value: valuesOf(key)[0] }]),
        up: (key) => act('key', [{ type: 'keyUp', value: valuesOf(key)[0] }]),
        press,
      },
      // The window has a toolbar.
      setViewportSize: ({ width, height }) => post('window/rect', { width, height: height + 100 }),
    }

    return {
      downloads: home,
      hands,
      open: (url) => post('url', { url }),
      evaluate,
      async drag(points) {
        const moves = points.map(({ x, y }) => ({
          type: 'pointerMove',
          duration: 16,
          // The protocol accepts whole pixels only.
          x: Math.round(x),
          y: Math.round(y),
        }))
        await mouse(...moves.slice(0, 1), { type: 'pointerDown', button: 0 }, ...moves.slice(1), {
          type: 'pointerUp',
          button: 0,
        })
      },
      async click(find, ...args) {
        const script = `return (${find})(...arguments) ?? null`
        const element: Record<string, string> | null = await post('execute/sync', { script, args })
        if (element !== null) await post(`element/${element[ELEMENT]}/click`, {})
        return element !== null
      },
      press,
      async choose(selector, path) {
        const element = await post('element', { using: 'css selector', value: selector })
        await post(`element/${element[ELEMENT]}/value`, { text: path })
      },
      close: () => close(sessionId),
    }
  } catch (error) {
    await close()
    throw error
  }
}

/** The newest browser among the packages of WebKitGTK, which are in a folder named for the machine. */
function miniBrowser(): string {
  const folder = `/usr/lib/${readdirSync('/usr/lib').find((name) => name.endsWith('-linux-gnu'))}`
  const browsers = readdirSync(folder)
    .filter((name) => /^webkit2?gtk-[\d.]+$/.test(name))
    .sort((one, other) => versionOf(one) - versionOf(other))
    .map((name) => `${folder}/${name}/MiniBrowser`)
    .filter((path) => existsSync(path))
  const newest = browsers.at(-1)
  if (newest === undefined) throw new Error(`There is no MiniBrowser of WebKitGTK in ${folder}.`)
  return newest
}

/** The version in a package's name: 4.1 for `webkit2gtk-4.1`, which is older than `webkitgtk-6.0`. */
function versionOf(name: string): number {
  return Number(name.slice(name.lastIndexOf('-') + 1))
}

/** The first line that a program writes to its fourth stream. */
function firstLine(child: ChildProcess): Promise<string> {
  return new Promise((resolve, reject) => {
    child.once('error', reject)
    child.stdio[3]?.once('data', (data: Buffer) => resolve(String(data).trim()))
  })
}

function freePort(): Promise<number> {
  return new Promise((resolve) => {
    const server = createServer()
    server.listen(0, '127.0.0.1', () => {
      const { port } = server.address() as { port: number }
      server.close(() => resolve(port))
    })
  })
}

/** A busy machine may take long to start it. */
async function listening(port: number): Promise<void> {
  for (let attempt = 0; attempt < 500; attempt++) {
    const answer = await fetch(`http://127.0.0.1:${port}/status`).catch(() => undefined)
    if (answer?.ok) return
    await new Promise((resolve) => setTimeout(resolve, 100))
  }
  throw new Error('WebKitWebDriver does not answer.')
}

function ended(child: ChildProcess): Promise<unknown> {
  if (child.exitCode !== null) return Promise.resolve()
  return new Promise((resolve) => {
    child.once('exit', resolve)
    child.kill()
  })
}
