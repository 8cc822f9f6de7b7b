// SPDX-License-Identifier: GPL-3.0-or-later
import { expect } from '@playwright/test'

/**
 * Asks until the expectation holds, like `expect.poll`, but at shorter intervals: a page answers within a few frames, and
 * Playwright's own intervals grow to a second. Each answer that does not fit yet costs Playwright some milliseconds.
 */
export const soon = <T>(ask: () => T | Promise<T>, message = '') =>
  expect.poll(ask, { message, intervals: [20, 30, 50, 100] })
