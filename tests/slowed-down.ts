// SPDX-License-Identifier: GPL-3.0-or-later
// Throttles the processor in every page of Chromium by a factor (`npm run test:steady`).
import { type Browser, chromium } from '@playwright/test'

export function slowDown(rate: number): void {
  const launch = chromium.launch.bind(chromium)
  chromium.launch = async (options) => {
    const browser = await launch(options)
    const newContext = browser.newContext.bind(browser)
    const slowed: Browser['newContext'] = async (contextOptions) => {
      const context = await newContext(contextOptions)
      context.on('page', async (page) => {
        // The page may have closed already.
        const session = await context.newCDPSession(page).catch(() => undefined)
        await session?.send('Emulation.setCPUThrottlingRate', { rate }).catch(() => undefined)
      })
      return context
    }
    browser.newContext = slowed
    return browser
  }
}
