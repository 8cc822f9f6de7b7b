// SPDX-License-Identifier: GPL-3.0-or-later
import { availableParallelism } from 'node:os'
import { defineConfig } from '@playwright/test'
import { CHROMIUM, HEADLESS_SHELL } from './tests/chromium.ts'
import { slowDown } from './tests/slowed-down.ts'

const PORT = Number(process.env.PORT ?? 4173)

const slowdown = process.env.CIRCLE_VORONOI_SLOWDOWN
if (slowdown !== undefined) slowDown(Number(slowdown))

export default defineConfig({
  projects: [
    // The longest tests first, so that all workers end together.
    { name: 'engines', testDir: 'tests/engines', use: { launchOptions: CHROMIUM } },
    { name: 'page', testDir: 'tests/e2e' },
    { name: 'package', testDir: 'tests/pack' },
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
    launchOptions: HEADLESS_SHELL,
  },
  // Serves the page like `npm start`. The build is up to date when tests run.
  webServer: {
    command: `node_modules/.bin/vite preview --port ${PORT} --strictPort`,
    url: `http://localhost:${PORT}`,
    reuseExistingServer: false,
  },
})
