// SPDX-License-Identifier: GPL-3.0-or-later
// The histograms of the panel Numbers, with a plot that notes its options.
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { Histogram } from '../../web/app/panels/histogram.ts'

const { plots } = vi.hoisted(() => ({ plots: [] as { given: unknown[]; destroyed: number }[] }))
vi.mock('uplot', () => ({
  default: class {
    static paths = { bars: (options: unknown) => ['bars', options] }
    readonly noted: { given: unknown[]; destroyed: number }
    constructor(...given: unknown[]) {
      this.noted = { given, destroyed: 0 }
      plots.push(this.noted)
    }
    destroy() {
      this.noted.destroyed += 1
    }
  },
}))

beforeEach(() => {
  plots.length = 0
  vi.stubGlobal('getComputedStyle', () => ({ color: 'ink', accentColor: 'accent', fontFamily: 'sans' }))
})
afterEach(() => vi.unstubAllGlobals())

it('has a bar in the middle of each class, in the colors of the page, as wide as its place', () => {
  const place = { clientWidth: 240 } as HTMLElement
  const histogram = new Histogram(place)
  histogram.show(Int32Array.of(3, 0, 2), 0.5, -0.5)
  const [options, data, at] = plots[0]?.given ?? []
  expect([data, at]).toEqual([
    [
      [0, 0.5, 1],
      [3, 0, 2],
    ],
    place,
  ])
  expect(options).toMatchObject({
    width: 240,
    height: 96,
    scales: { x: { time: false, range: [-0.25, 1.25] } },
    axes: [
      { stroke: 'ink', font: '11px sans' },
      { stroke: 'ink', font: '11px sans' },
    ],
    series: [{}, { fill: 'accent', paths: ['bars', { size: [0.9, 60], align: 0 }] }],
  })
})

it('is drawn anew each time, not at all without classes, and gone once disposed', () => {
  const histogram = new Histogram({ clientWidth: 240 } as HTMLElement)
  const destroyed = () => plots.map(({ destroyed }) => destroyed)
  histogram.show(Int32Array.of(1), 1, 0)
  histogram.show(Int32Array.of(2), 1, 0)
  expect(destroyed()).toEqual([1, 0])
  histogram.show(Int32Array.of(), 1, 0)
  expect(destroyed()).toEqual([1, 1])
  histogram.dispose()
  expect(destroyed(), 'there is no plot').toEqual([1, 1])
  histogram.show(Int32Array.of(3), 1, 0)
  histogram.dispose()
  expect(destroyed()).toEqual([1, 1, 1])
})
