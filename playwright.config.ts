// SPDX-License-Identifier: GPL-3.0-or-later
import { availableParallelism } from 'node:os'
import { defineConfig } from '@playwright/test'
import { slowDown } from './tests/slowed-down.ts'

const PORT = Number(process.env.PORT ?? 4173)

const slowdown = process.env.CIRCLE_VORONOI_SLOWDOWN
if (slowdown !== undefined) slowDown(Number(slowdown))

/**
 * Disables features of Chromium that tests do not need. For each window, which every test opens anew, it would start
 * one process for a list below its address bar, and one for a next page, which takes two thirds of the time of an empty
 * test. Only the last of several such options counts, so the list includes those of Playwright.
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

export default defineConfig({
  projects: [
    { name: 'page', testDir: 'tests/e2e' },
    { name: 'package', testDir: 'tests/pack' },
    { name: 'engines', testDir: 'tests/engines' },
  ],
  // Other tests in these folders are for Node's runner.
  testMatch: '**/*.spec.ts',
  outputDir: 'build/playwright',
  // One browser for each core.
  workers: availableParallelism(),
  forbidOnly: Boolean(process.env.CI),
  // The browsers use all cores, so waiting may take a while. No test is about its duration.
  timeout: 120_000,
  expect: { timeout: 15_000 },
  use: {
    baseURL: `http://localhost:${PORT}`,
    viewport: { width: 1280, height: 800 },
    // Disables animations. Tests of animations allow them.
    contextOptions: { reducedMotion: 'reduce' },
    // Each test would download the whole site. Tests of the service worker allow it.
    serviceWorkers: 'block',
    launchOptions: {
      executablePath: process.env.CHROMIUM_PATH ?? '/usr/bin/chromium',
      args: [
        '--headless',
        '--no-sandbox',
        '--disable-gpu',
        '--disable-quic',
        '--no-first-run',
        '--disable-background-networking',
        '--disable-component-update',
        '--disable-sync',
        `--disable-features=${FEATURES_WITHOUT_USE.join()}`,
      ],
    },
  },
  // Serves the page like `npm start`. The build is up to date when tests run.
  webServer: {
    command: `node_modules/.bin/vite preview --port ${PORT} --strictPort`,
    url: `http://localhost:${PORT}`,
    reuseExistingServer: false,
  },
})
