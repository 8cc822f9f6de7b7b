// SPDX-License-Identifier: GPL-3.0-or-later
import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import puppeteer, { type ElementHandle, type JSHandle, type KeyInput } from 'puppeteer-core'
import type { Point } from '../../web/lib/index.ts'
import { type Engine, inWindow, keysOf } from './engine.ts'

/** Firefox, over WebDriver BiDi. */
export async function openFirefox(): Promise<Engine> {
  const downloads = mkdtempSync(`${tmpdir()}/firefox-`)
  const browser = await puppeteer.launch({
    browser: 'firefox',
    executablePath: process.env.FIREFOX_PATH ?? '/usr/bin/firefox-esr',
    headless: true,
    // The test's own time limit is enough.
    timeout: 0,
    protocolTimeout: 0,
    defaultViewport: { width: 1280, height: 800 },
    // Saves downloads in the given folder.
    extraPrefsFirefox: { 'browser.download.folderList': 2, 'browser.download.dir': downloads },
  })
  const page = await browser.newPage()
  page.setDefaultTimeout(0)
  const press = async (keys: string) => {
    const held = keysOf(keys) as KeyInput[]
    const last = held.pop() as KeyInput
    for (const key of held) await page.keyboard.down(key)
    await page.keyboard.press(last)
    for (const key of held.reverse()) await page.keyboard.up(key)
  }
  const clamped = (x: number, y: number) => page.evaluate(inWindow, [x, y] as [number, number])
  const { mouse, keyboard } = page
  return {
    downloads,
    hands: {
      evaluate: (call, arg) => page.evaluate(call as never, arg),
      mouse: {
        move: async (x, y, options) => mouse.move(...(await clamped(x, y)), options),
        down: (options) => mouse.down(options),
        up: (options) => mouse.up(options),
        click: async (x, y, options) => mouse.click(...(await clamped(x, y)), { count: options?.clickCount ?? 1 }),
        wheel: (deltaX, deltaY) => mouse.wheel({ deltaX, deltaY }),
      },
      keyboard: {
        down: (key) => keyboard.down(keysOf(key)[0] as KeyInput),
        up: (key) => keyboard.up(keysOf(key)[0] as KeyInput),
        press,
      },
      setViewportSize: (size) => page.setViewport(size),
    },
    async open(url) {
      await page.goto(url)
    },
    // Its types accept only plain functions.
    evaluate: (call, ...args) => page.evaluate(call as never, ...args),
    async drag([first, ...others]) {
      const { x, y } = first as Point
      await page.mouse.move(x, y)
      await page.mouse.down()
      for (const to of others) await page.mouse.move(to.x, to.y)
      await page.mouse.up()
    },
    async click(find, ...args) {
      const found: JSHandle = await page.evaluateHandle(find as never, ...args)
      const element = found.asElement() as ElementHandle<Element> | null
      await element?.click()
      return element !== null
    },
    press,
    async choose(selector, path) {
      const input = (await page.$(selector)) as ElementHandle<HTMLInputElement>
      await input.uploadFile(path)
    },
    async close() {
      await browser.close()
      rmSync(downloads, { recursive: true, force: true })
    },
  }
}
