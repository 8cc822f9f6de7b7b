// SPDX-License-Identifier: GPL-3.0-or-later
import { defineConfig } from 'vitest/config'

export default defineConfig({
  test: {
    include: ['tests/web/**/*.test.ts'],
    setupFiles: ['tests/mutants/same-random-numbers.ts'],
    // Counting what runs takes time.
    testTimeout: 300_000,
  },
})
