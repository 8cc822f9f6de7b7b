// SPDX-License-Identifier: GPL-3.0-or-later
import type { Page } from '@playwright/test'

/** Waits until a page has drawn at least `count` frames. */
export async function framesOf(page: Page, count: number): Promise<void> {
  for (let k = 0; k < count; k++) await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(resolve)))
}
