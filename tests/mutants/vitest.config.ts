// SPDX-License-Identifier: GPL-3.0-or-later
import { defineConfig } from 'vitest/config'

export default defineConfig({
  test: {
    include: ['tests/web/**/*.test.ts'],
    setupFiles: ['tests/mutants/same-random-numbers.ts'],
    // Measuring coverage takes time.
    testTimeout: 300_000,
  },
})
