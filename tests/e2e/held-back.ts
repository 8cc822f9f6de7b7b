// SPDX-License-Identifier: GPL-3.0-or-later
import type { Page } from '@playwright/test'

/** Waits until a page has got what it asked for at an address, once that is answered: what it asks for now comes later. */
export async function got(page: Page, address: string): Promise<void> {
  await page.evaluate(async (address) => {
    await (await fetch(address, { cache: 'no-store' })).text()
  }, address)
}

/** Has what pages ask for at an address wait until the function that this returns is called. */
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
