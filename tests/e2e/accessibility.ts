// SPDX-License-Identifier: GPL-3.0-or-later
import { AxeBuilder } from '@axe-core/playwright'
import type { Page } from '@playwright/test'

/**
 * What of a page, or of its part that a selector names, is not accessible. All is in one document: a second page, which would
 * bring together what frames say, takes as long as the analysis.
 */
export async function violationsOf(page: Page, part?: string) {
  const axe = new AxeBuilder({ page }).setLegacyMode().options({ resultTypes: ['violations'] })
  return (await (part === undefined ? axe : axe.include(part)).analyze()).violations
}
