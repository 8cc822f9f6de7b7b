// SPDX-License-Identifier: GPL-3.0-or-later
import { availableParallelism } from 'node:os'
import { defineConfig } from '@playwright/test'
import { slowDown } from './tests/slowed-down.ts'

const PORT = Number(process.env.PORT ?? 4173)

const slowdown = process.env.CIRCLE_VORONOI_SLOWDOWN
if (slowdown !== undefined) slowDown(Number(slowdown))

/**
 * What Chromium need not do. Each test has a window of its own, for which it would start a process with a list below its address
 * bar, and one for a next page: that takes two thirds of the time of an empty test. Only the last of several such options
 * counts, so the others are those of Playwright.
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
  // Others in these folders are for Node's runner.
  testMatch: '**/*.spec.ts',
  outputDir: 'build/playwright',
  // A browser for each core.
  workers: availableParallelism(),
  forbidOnly: Boolean(process.env.CI),
  // Browsers for all cores leave none idle: what is waited for may take a while, and no test is about how long.
  timeout: 120_000,
  expect: { timeout: 15_000 },
  use: {
    baseURL: `http://localhost:${PORT}`,
    viewport: { width: 1280, height: 800 },
    // Nothing moves by itself. What is about that allows it.
    contextOptions: { reducedMotion: 'reduce' },
    // Each test would fetch the whole site. What is about it allows it.
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
  // The page as `npm start` serves it; the tests' builds are up to date by then.
  webServer: {
    command: `node_modules/.bin/vite preview --port ${PORT} --strictPort`,
    url: `http://localhost:${PORT}`,
    reuseExistingServer: false,
  },
})
