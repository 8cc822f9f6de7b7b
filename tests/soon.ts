// SPDX-License-Identifier: GPL-3.0-or-later
import { expect } from '@playwright/test'

/**
 * Asks until the expectation holds, like `expect.poll`, but every 20 ms: a page answers within a frame or two, and
 * Playwright's own intervals grow to a second.
 */
export const soon = <T>(ask: () => T | Promise<T>, message = '') => expect.poll(ask, { message, intervals: [20] })
