// SPDX-License-Identifier: GPL-3.0-or-later
import { describe, expect, it, vi } from 'vitest'
import { hiddenWarning, loadCircleVoronoi } from '../../web/lib/index.ts'
import { loadLibrary } from '../../web/lib/wasm/loader.ts'

/** Radii in meters around places in degrees. */
const MANY_HIDDEN: [number, number, number][] = [
  [0, 0, 500],
  [3, 4, 120],
  [9, 1, 80],
]
const FEW_HIDDEN: [number, number, number][] = [
  [0, 0, 2],
  [0.5, 0, 1],
  [5, 0, 1],
  [9, 9, 1],
]

describe('the warning about hidden circles', () => {
  it('counts them if they are more than a quarter', async () => {
    const { compute } = await loadLibrary()
    expect(hiddenWarning(compute(MANY_HIDDEN))).toMatch(/^2 of 3 circles are hidden inside others/)
    expect(hiddenWarning(compute(FEW_HIDDEN))).toBe('')
    expect(hiddenWarning(compute([]))).toBe('')
  })

  it('is printed once', async () => {
    const warned = vi.spyOn(console, 'warn').mockImplementation(() => {})
    try {
      const library = await loadCircleVoronoi()
      library.compute(FEW_HIDDEN)
      expect(warned).not.toHaveBeenCalled()
      library.compute(MANY_HIDDEN)
      library.compute(MANY_HIDDEN)
      expect(warned.mock.calls).toEqual([[expect.stringMatching(/^circle-voronoi: 2 of 3 circles are hidden/)]])
    } finally {
      warned.mockRestore()
    }
  })
})
