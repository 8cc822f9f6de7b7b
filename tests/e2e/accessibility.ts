// SPDX-License-Identifier: GPL-3.0-or-later
import { AxeBuilder } from '@axe-core/playwright'
import type { Page } from '@playwright/test'
import { framesOf } from './frames.ts'

/**
 * Returns the accessibility violations of a page, or of the part that a selector names. Legacy mode analyzes a single
 * document. The default mode opens a second page to merge the results of frames, which takes as long as the analysis.
 */
export async function violationsOf(page: Page, part?: string, rules?: string[]) {
  const options = {
    resultTypes: ['violations' as const],
    ...(rules && { runOnly: { type: 'rule' as const, values: rules } }),
  }
  const axe = new AxeBuilder({ page }).setLegacyMode().options(options)
  return (await (part === undefined ? axe : axe.include(part)).analyze()).violations
}

/** The rules that depend on colors. */
const RULES_OF_COLORS = ['color-contrast', 'link-in-text-block']

/** Returns the accessibility violations of a page in light and in dark colors. */
export async function violationsInBoth(page: Page) {
  await page.emulateMedia({ colorScheme: 'light' })
  const inLight = await violationsOf(page)
  await page.emulateMedia({ colorScheme: 'dark' })
  await framesOf(page, 2)
  return [...inLight, ...(await violationsOf(page, undefined, RULES_OF_COLORS))]
}
