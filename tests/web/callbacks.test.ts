// SPDX-License-Identifier: GPL-3.0-or-later
import { beforeAll, describe, expect, it } from 'vitest'
import { type CircleVoronoi, type DiagramEditor, loadCircleVoronoi } from '../../web/lib/index.ts'
import { loadRegions } from '../../web/lib/regions.ts'

let library: CircleVoronoi

beforeAll(async () => {
  library = await loadCircleVoronoi()
})

const CIRCLES: [number, number, number][] = Array.from({ length: 60 }, (_, i) => [i % 8, (i * 0.37) % 7, (i % 5) / 20])

/** Calls the library as a callback may. */
function callLibrary(): void {
  expect(library.compute(CIRCLES).circles).toHaveLength(180)
  const editor = library.edit(CIRCLES)
  editor.remove(3)
  editor.dispose()
}

function expectEqualToComputed(editor: DiagramEditor): void {
  const snapshot = editor.snapshot()
  expect([...snapshot.vertices].sort()).toEqual([...library.compute(snapshot.circles).vertices].sort())
}

describe('a callback', () => {
  it('for progress may call the library', () => {
    const expected = library.compute(CIRCLES, { method: 'touching-disc' })
    let calls = 0
    const progress = () => {
      calls += 1
      callLibrary()
    }
    expect(library.compute(CIRCLES, { method: 'touching-disc', progress }).vertices).toEqual(expected.vertices)
    expect(calls).toBeGreaterThan(5)
  })

  it('for steps of a fit may call the library and fit', async () => {
    const regions = await loadRegions()
    const region = regions.region([
      [
        [0, 0],
        [8, 0],
        [8, 7],
        [0, 7],
      ],
    ])
    const sites: [number, number, number][] = [
      [1, 1, 0],
      [6, 2, 0],
      [3, 5, 0],
    ]
    const options = { region, shares: true }
    const expected = regions.fitAreas(sites, [1, 2, 3], options).weights
    let calls = 0
    const onStep = () => {
      calls += 1
      callLibrary()
      expect(regions.fitAreas(sites, [1, 2, 3], options).weights).toEqual(expected)
    }
    expect(regions.fitAreas(sites, [1, 2, 3], { ...options, onStep }).weights).toEqual(expected)
    expect(calls).toBeGreaterThan(1)
  })

  it('for changes may read, edit and follow its editor', () => {
    const editor = library.edit(CIRCLES)
    const copy = editor.snapshot()
    const sizes: number[] = []
    editor.onchange = (change) => {
      copy.apply(change)
      sizes.push(editor.size())
      expect(editor.certificate().certified).toBe(true)
      if (editor.size() > 50) editor.remove(Math.min(...editor.ids()))
    }
    editor.insert([3.3, 3.3, 0.01])
    expect(sizes).toEqual([61, 60, 59, 58, 57, 56, 55, 54, 53, 52, 51, 50])
    expect([...copy.vertices].sort()).toEqual([...editor.snapshot().vertices].sort())
    expectEqualToComputed(editor)
  })

  it('for changes may replace itself and dispose of its editor', () => {
    const editor = library.edit(CIRCLES)
    const calls: string[] = []
    editor.onchange = () => {
      calls.push('first')
      editor.onchange = (change) => {
        calls.push('second')
        editor.dispose()
        expect(change.removed).toEqual(Int32Array.of(4))
      }
    }
    editor.remove(3)
    expect(editor.remove(4).removed).toEqual(Int32Array.of(4))
    expect(calls).toEqual(['first', 'second'])
    expect(() => editor.size()).toThrow(expect.objectContaining({ code: 'badInput' }))
  })

  it('for changes sees a change that a nested edit does not alter', () => {
    const editor = library.edit(CIRCLES)
    editor.onchange = (change) => {
      editor.onchange = undefined
      const before = structuredClone(change)
      editor.insert([3.4, 3.4, 0.3])
      expect(structuredClone(change)).toEqual(before)
    }
    editor.insert([3.3, 3.3, 0.01])
    expectEqualToComputed(editor)
  })
})
