// SPDX-License-Identifier: GPL-3.0-or-later
// One table of texts for every reader of circles: the program, the module for files, and the small reader of the
// element and the page. All return the same circles, to the bit, or reject the same line or circle.
import { spawnSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { expect, it } from 'vitest'
import { loadFiles } from '../../web/lib/files.ts'
import { CircleVoronoiError } from '../../web/lib/index.ts'
import { circlesOfText } from '../../web/view/circle-text.ts'
import { TextProblem } from '../../web/view/table-text.ts'

interface Reading {
  readonly what: string
  readonly text: string
  readonly circles?: readonly number[]
  /** The rejected line or circle. Without either, the text as a whole is rejected. */
  readonly line?: number
  readonly circle?: number
}

/** The circles, or the rejected line or circle. */
type Outcome = { readonly circles: Float64Array } | { readonly line?: number; readonly circle?: number }

const PROGRAM = new URL('../../build/native/circle-voronoi', import.meta.url).pathname
const READINGS: readonly Reading[] = JSON.parse(readFileSync(new URL('readings.json', import.meta.url), 'utf8'))
const files = await loadFiles()

function expected({ circles, line, circle }: Reading): Outcome {
  if (circles !== undefined) return { circles: Float64Array.from(circles) }
  return { ...(line !== undefined && { line }), ...(circle !== undefined && { circle }) }
}

/** Converts an error of the library to the form of a reading. */
function refused(reading: Reading, message: string, circle: number | undefined): Outcome {
  const line = Number(/^[^:]*:(\d+): /.exec(message)?.[1])
  return { ...(reading.line !== undefined && { line }), ...(reading.circle !== undefined && { circle }) } as Outcome
}

const readers: Readonly<Record<string, (reading: Reading) => Outcome>> = {
  program: (reading) => {
    const { status, stdout, stderr } = spawnSync(PROGRAM, ['convert', '-', '--format', 'json'], {
      input: reading.text,
      encoding: 'utf8',
    })
    if (status === 0) {
      const circles = JSON.parse(stdout) as readonly { x: number; y: number; r: number }[]
      return { circles: Float64Array.from(circles.flatMap(({ x, y, r }) => [x, y, r])) }
    }
    expect([status, stderr]).toEqual([2, expect.stringMatching(/^circle-voronoi: standard input:\d+: .+\n$/)])
    // The program reports only lines, also for JSON.
    return refused(reading, stderr.slice(stderr.indexOf(' ') + 1), reading.circle)
  },
  files: (reading) => {
    try {
      return { circles: files.readCircles(reading.text) }
    } catch (error) {
      const { message, circle } = error as CircleVoronoiError
      expect(error).toBeInstanceOf(CircleVoronoiError)
      return refused(reading, message, circle)
    }
  },
  'element and page': (reading) => {
    try {
      return { circles: circlesOfText(reading.text) }
    } catch (error) {
      expect(error).toBeInstanceOf(TextProblem)
      const { line, circle } = error as TextProblem
      // The program reports no line for an empty text.
      return { ...(reading.line !== undefined && { line: line ?? 1 }), ...(circle !== undefined && { circle }) }
    }
  },
}

for (const [name, read] of Object.entries(readers)) {
  it.each(READINGS)(`${name}: $what`, (reading) => {
    expect(read(reading)).toEqual(expected(reading))
  })
}
