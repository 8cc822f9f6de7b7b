// SPDX-License-Identifier: GPL-3.0-or-later
import type { CircleVoronoi, Float64s } from '../lib/index.ts'

/** The numbers of samples on circles. */
export interface SampleCounts {
  /** The number on the largest circle. */
  readonly largest: number
  /** The least and the greatest number on the other circles. */
  readonly others: readonly [fewest: number, most: number]
  readonly average: number
}

/** Counts the samples that dynamic sampling takes, with `samples` in each angle. */
export function countSamples(library: CircleVoronoi, circles: Float64s, samples: number): SampleCounts {
  const trace = library.trace(circles, { samples })
  const counts = new Array<number>(circles.length / 3).fill(0)
  for (const k of trace.at(trace.length).samples) {
    const [circle] = trace.event(k).circles
    counts[circle as number] = (counts[circle as number] ?? 0) + 1
  }
  const radii = circles.filter((_, k) => k % 3 === 2)
  const first = radii.indexOf(Math.max(...radii))
  const others = counts.filter((_, i) => i !== first)
  return {
    largest: counts[first] ?? 0,
    others: [Math.min(...others), Math.max(...others)],
    average: counts.reduce((sum, count) => sum + count, 0) / counts.length,
  }
}

export function sentenceOf({ largest, others: [fewest, most], average }: SampleCounts): string {
  const others = fewest === most ? `${fewest}` : `${fewest} to ${most}`
  return `${largest} samples on the largest circle, ${others} on each other one, ${average.toFixed(3)} on average.`
}
