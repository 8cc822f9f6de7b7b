// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the paper's rules as printed, and compares their result with the diagram.
import {
  bisector,
  type DiagramData,
  type EdgeCurve,
  edgeCurve,
  type Float64s,
  type Int32s,
  type Point,
  parameterAt,
} from '../lib/index.ts'
import { compileWasm, instantiate, unwrap, type WasmSource } from '../lib/wasm/wasm.ts'
import createModule from './generated/printed.js'

/**
 * The rules that can be set to the paper's version, by their names in cpp/printed/printed_algorithm.h. All other rules
 * are the corrected ones.
 */
export const RULES = ['side', 'third', 'crossing', 'inside'] as const
export type Rule = (typeof RULES)[number]

/** The rules test all pairs, so more circles would be too slow during a drag. */
export const MOST_CIRCLES = 40

/** The module's result. */
export interface Printed {
  /** The circles on the right and on the left of each segment. */
  readonly segmentCircles: Int32s
  /** x, y and r of the discs at its ends. */
  readonly segmentDiscs: Float64s
  /** The circles at the start and the end of each directed edge that is left over. */
  readonly leftoverCircles: Int32s
  /** x, y and r of the disc of each such edge. */
  readonly leftoverDiscs: Float64s
  /** The direction from the center of either circle to its foot point, of any length: x and y each. */
  readonly leftoverFeet: Float64s
}

export interface PrintedRules {
  /** Runs the method with the rules in `asPrinted` set to the paper's version. */
  run(circles: Float64Array, asPrinted: readonly Rule[]): Printed
}

/**
 * Loads the module.
 * @throws CircleVoronoiError `notLoaded`
 */
export async function loadPrintedRules(wasm?: WasmSource): Promise<PrintedRules> {
  const module = await instantiate(
    createModule,
    await compileWasm(wasm, () => new URL('./generated/printed.wasm', import.meta.url)),
  )
  return { run: (circles, asPrinted) => unwrap(module.printed(circles, asPrinted)) }
}

/** An arrow from one rim to another. */
export interface Arrow {
  readonly from: Point
  readonly to: Point
  /** Whether the border is unbounded. A left-over directed edge is then correct. */
  readonly isRight: boolean
}

/** The result of the printed rules compared with the diagram. */
export interface Comparison {
  /** The parts of borders that the rules find. */
  readonly found: readonly EdgeCurve[]
  /** The curves that the rules wrongly take for parts of borders. */
  readonly wrong: readonly EdgeCurve[]
  /** The borders that the rules miss, or find only in part. */
  readonly missing: readonly EdgeCurve[]
  /** The directed edges that are left over. */
  readonly leftover: readonly Arrow[]
  /** The number of borders. */
  readonly borders: number
}

/** A part of a bisector, with the circles on its sides. */
interface Part {
  readonly left: number
  readonly right: number
  readonly curve: EdgeCurve
}

/** Tolerance for comparing ends of parts. Curve parameters are exact up to rounding. */
const NEAR = 1e-6

export function compare(diagram: DiagramData, printed: Printed): Comparison {
  const { circles, edges } = diagram
  const borders = Array.from({ length: edges.length / 4 }, (_, e) => ({
    left: edges[4 * e] as number,
    right: edges[4 * e + 1] as number,
    curve: edgeCurve(diagram, e),
  })).filter(({ curve }) => !isNear(curve.from, curve.to))
  const isRight = (part: Part) => borders.some((border) => within(part, border) !== undefined)

  const segments = segmentsOf(circles, printed).filter(({ curve }) => !isNear(curve.from, curve.to))
  const leftover = leftoverOf(circles, printed)
  const found = [...segments, ...leftover.map(({ part }) => part)].filter(isRight)
  return {
    found: found.map(({ curve }) => curve),
    // A directed edge that is left over is drawn as an arrow, not as a curve.
    wrong: segments.filter((part) => !isRight(part)).map(({ curve }) => curve),
    missing: borders.filter((border) => !isCovered(border, found)).map(({ curve }) => curve),
    leftover: leftover.map(({ part, arrow }) => ({ ...arrow, isRight: isRight(part) })),
    borders: borders.length,
  }
}

/** Describes a comparison in one sentence. */
export function sentenceOf({ wrong, missing, leftover, borders }: Comparison): string {
  const lost = leftover.filter(({ isRight }) => !isRight).length
  if (wrong.length + missing.length + lost === 0) return 'As printed: the same diagram here.'
  const lines = wrong.length === 0 ? '' : `, and ${count(wrong.length, 'line')} where there is no border`
  const arrows = lost === 0 ? '' : ` ${count(lost, 'leftover directed edge')} should not be there.`
  return `As printed: ${borders - missing.length} of ${count(borders, 'border')} found${lines}.${arrows}`
}

function count(number: number, what: string): string {
  return `${number} ${what}${number === 1 ? '' : 's'}`
}

function segmentsOf(circles: Float64Array, { segmentCircles, segmentDiscs }: Printed): Part[] {
  return Array.from({ length: segmentCircles.length / 2 }, (_, k) =>
    partOf(circles, segmentCircles, k, pointOf(segmentDiscs, 2 * k), pointOf(segmentDiscs, 2 * k + 1)),
  )
}

function leftoverOf(circles: Float64Array, { leftoverCircles, leftoverDiscs, leftoverFeet }: Printed) {
  return Array.from({ length: leftoverCircles.length / 2 }, (_, k) => {
    const foot = (end: number): Point => {
      const [x, y, r] = circles.subarray(3 * (leftoverCircles[2 * k + end] as number)) as unknown as number[]
      const [u, v] = leftoverFeet.subarray(4 * k + 2 * end) as unknown as [number, number]
      const share = (r as number) / (Math.hypot(u, v) || 1)
      return { x: (x as number) + share * u, y: (y as number) + share * v }
    }
    return {
      part: partOf(circles, leftoverCircles, k, pointOf(leftoverDiscs, k), undefined),
      arrow: { from: foot(0), to: foot(1) },
    }
  })
}

/** The part of a bisector on the right of a directed edge, between two discs or without an end. */
function partOf(circles: Float64Array, pairs: Int32s, k: number, start: Point, end: Point | undefined): Part {
  const [right, left] = [pairs[2 * k] as number, pairs[2 * k + 1] as number]
  const curve = bisector(circles, left, right)
  const from = parameterAt(curve, start.x, start.y)
  const to = end === undefined ? Number.POSITIVE_INFINITY : parameterAt(curve, end.x, end.y)
  // A wrong part may run backwards.
  return from <= to
    ? { left, right, curve: { bisector: curve, from, to, start, end } }
    : { left, right, curve: { bisector: curve, from: to, to: from, start: end, end: start } }
}

function pointOf(discs: Float64Array, k: number): Point {
  return { x: discs[3 * k] as number, y: discs[3 * k + 1] as number }
}

/** The range of parameters of a border that a part covers; `undefined` if the part lies on another curve. */
function within(part: Part, border: Part): [from: number, to: number] | undefined {
  const { from, to } = part.curve
  const isTurned = part.left === border.right && part.right === border.left
  if (!isTurned && (part.left !== border.left || part.right !== border.right)) return undefined
  const [first, last] = isTurned ? [1 / to, 1 / from] : [from, to]
  const { curve } = border
  const isInside = (first >= curve.from || isNear(first, curve.from)) && (last <= curve.to || isNear(last, curve.to))
  return isInside ? [first, last] : undefined
}

function isCovered(border: Part, parts: readonly Part[]): boolean {
  const ranges = parts.flatMap((part) => {
    const range = within(part, border)
    return range === undefined ? [] : [range]
  })
  let reached = border.curve.from
  for (const [from, to] of ranges.sort(([u], [v]) => u - v)) {
    if (from <= reached || isNear(from, reached)) reached = Math.max(reached, to)
  }
  return reached >= border.curve.to || isNear(reached, border.curve.to)
}

function isNear(u: number, v: number): boolean {
  return u === v || Math.abs(u - v) <= NEAR * Math.min(u, v)
}
