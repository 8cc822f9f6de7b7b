// SPDX-License-Identifier: GPL-3.0-or-later
import type { Page } from '@playwright/test'

/** Waits until a page has received the response for an address, so that later requests follow it. */
export async function got(page: Page, address: string): Promise<void> {
  await page.evaluate(async (address) => {
    await (await fetch(address, { cache: 'no-store' })).text()
  }, address)
}

/** Holds back the responses to requests for an address until the returned function is called. */
export async function heldBack(address: string, ...pages: Page[]): Promise<() => void> {
  let answer = () => {}
  const answered = new Promise<void>((resolve) => {
    answer = resolve
  })
  for (const page of pages) {
    await page.route(address, async (route) => {
      await answered
      await route.continue()
    })
  }
  return answer
}
