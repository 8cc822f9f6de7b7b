// SPDX-License-Identifier: GPL-3.0-or-later
import { AxeBuilder } from '@axe-core/playwright'
import type { Page } from '@playwright/test'
import { framesOf } from './frames.ts'

/**
 * What of a page, or of its part that a selector names, is not accessible. All is in one document: a second page, which would
 * bring together what frames say, takes as long as the analysis.
 */
export async function violationsOf(page: Page, part?: string, rules?: string[]) {
  const options = {
    resultTypes: ['violations' as const],
    ...(rules && { runOnly: { type: 'rule' as const, values: rules } }),
  }
  const axe = new AxeBuilder({ page }).setLegacyMode().options(options)
  return (await (part === undefined ? axe : axe.include(part)).analyze()).violations
}

/** What the colors of a page decide. */
const RULES_OF_COLORS = ['color-contrast', 'link-in-text-block']

/** What of a page is not accessible in light colors or in dark ones. */
export async function violationsInBoth(page: Page) {
  await page.emulateMedia({ colorScheme: 'light' })
  const inLight = await violationsOf(page)
  await page.emulateMedia({ colorScheme: 'dark' })
  await framesOf(page, 2)
  return [...inLight, ...(await violationsOf(page, undefined, RULES_OF_COLORS))]
}
