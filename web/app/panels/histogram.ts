// SPDX-License-Identifier: GPL-3.0-or-later
import uPlot from 'uplot'
import 'uplot/dist/uPlot.min.css'

const HEIGHT = 96

/** A histogram in an element. */
export class Histogram {
  readonly place: HTMLElement
  #plot: uPlot | undefined

  constructor(place: HTMLElement) {
    this.place = place
  }

  dispose(): void {
    this.#plot?.destroy()
  }

  /** Class k has its bar centered between k + `first` and k + 1 + `first` times `step`. */
  show(counts: Int32Array, step: number, first: number): void {
    const style = getComputedStyle(this.place)
    const ink = style.color
    const axis = {
      stroke: ink,
      font: `11px ${style.fontFamily}`,
      grid: { show: false },
      ticks: { stroke: ink, width: 0.5, size: 3 },
    }
    this.#plot?.destroy()
    this.#plot = new uPlot(
      {
        width: this.place.clientWidth,
        height: HEIGHT,
        padding: [6, 8, 0, 0],
        cursor: { show: false },
        legend: { show: false },
        scales: { x: { time: false, range: [first * step, (first + counts.length) * step] } },
        axes: [
          { ...axis, size: 22, gap: 2 },
          { ...axis, size: 44, gap: 2, space: 24 },
        ],
        series: [
          {},
          {
            fill: style.accentColor,
            points: { show: false },
            paths: (uPlot.paths.bars as uPlot.Series.BarsPathBuilderFactory)({ size: [0.9, 60], align: 0 }),
          },
        ],
      },
      [Array.from(counts, (_, k) => (k + first + 0.5) * step), [...counts]],
      this.place,
    )
  }
}
