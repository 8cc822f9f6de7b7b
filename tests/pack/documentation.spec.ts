// SPDX-License-Identifier: GPL-3.0-or-later
import { existsSync, mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { expect, test } from '@playwright/test'
import { BIN, ROOT, run } from './project.ts'

test('every exported name has a doc comment, and no link in one is broken', () => {
  test.setTimeout(120_000)
  const out = mkdtempSync(join(tmpdir(), 'circle-voronoi-docs-'))
  try {
    // Anything that TypeDoc has to complain of is an error (typedoc.json).
    run(ROOT, join(BIN, 'typedoc'), '--out', out)
    for (const module of [
      'circle-voronoi',
      'circle-voronoi_worker',
      'circle-voronoi_comparison',
      'circle-voronoi_files',
      'circle-voronoi_link',
      'circle-voronoi_bundle',
    ]) {
      expect(existsSync(join(out, `modules/${module}.html`)), module).toBe(true)
    }
  } finally {
    rmSync(out, { recursive: true, force: true })
  }
})
