// SPDX-License-Identifier: GPL-3.0-or-later
// The Chromium that Playwright drives.
import type { LaunchOptions } from '@playwright/test'
import { chromiumPath, chromiumShellPath } from '../scripts/setup.mjs'

/**
 * Features of Chromium that no test needs. A window starts a process for the list below the address bar, and another one for
 * the next page: two thirds of the time of an empty test. Chromium reads only the last `--disable-features`, so the list
 * repeats what Playwright disables.
 */
const FEATURES_WITHOUT_USE = [
  ...['WebUIOmniboxPopup', 'WebUIOmniboxAimPopup', 'WebUIOmniboxFullPopup', 'SpareRendererForSitePerProcess'],
  ...['AimEnabled', 'AvoidCorsURLLoaderRestartOnRedirect', 'AvoidUnnecessaryBeforeUnloadCheckSync', 'LensOverlay'],
  ...[
    'DestroyProfileOnBrowserClose',
    'HttpsFirstBalancedModeAutoEnable',
    'HttpsUpgrades',
    'MediaRouter',
    'PaintHolding',
  ],
  ...['NetworkTimeServiceQuerying', 'OptimizationHints', 'PreconnectToSearch', 'ThirdPartyStoragePartitioning'],
]

const ARGS = [
  '--headless',
  '--no-sandbox',
  '--disable-gpu',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  `--disable-features=${FEATURES_WITHOUT_USE.join()}`,
]

/** The browser as people have it, for tests of service workers, paper and videos. */
export const CHROMIUM: LaunchOptions = {
  executablePath: chromiumPath(),
  args: ARGS,
}

/** The same engine without the parts around a page: an empty test takes half of the processor time. */
export const HEADLESS_SHELL: LaunchOptions = {
  executablePath: chromiumShellPath(),
  args: ARGS,
}
