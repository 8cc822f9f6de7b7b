// SPDX-License-Identifier: GPL-3.0-or-later
import type { PathSink } from '../../lib/index.ts'

/** The number of coordinates of each command: moveTo, lineTo, bezierCurveTo, closePath. */
const LENGTHS = [2, 2, 6, 0] as const

/**
 * Encodes a drawing as numbers: each command, 0 to 3, followed by its coordinates. Outlines contain no circular arcs.
 */
export function commandsOf(draw: (sink: PathSink) => void): Float64Array {
  const numbers: number[] = []
  draw({
    moveTo: (x, y) => numbers.push(0, x, y),
    lineTo: (x, y) => numbers.push(1, x, y),
    bezierCurveTo: (...points) => numbers.push(2, ...points),
    arc: () => {},
    closePath: () => numbers.push(3),
  })
  return Float64Array.from(numbers)
}

/** Draws encoded commands. */
export function replay(commands: Float64Array, sink: PathSink): void {
  let k = 0
  while (k < commands.length) {
    const command = commands[k] as 0 | 1 | 2 | 3
    const n = (i: number) => commands[k + i] as number
    if (command === 0) sink.moveTo(n(1), n(2))
    else if (command === 1) sink.lineTo(n(1), n(2))
    else if (command === 2) sink.bezierCurveTo(n(1), n(2), n(3), n(4), n(5), n(6))
    else sink.closePath()
    k += 1 + LENGTHS[command]
  }
}
