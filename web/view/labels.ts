// SPDX-License-Identifier: GPL-3.0-or-later
import type { Box, Point } from '../lib/index.ts'
import { type CircleTable, imagesOf } from './circle-table.ts'
import type { Frame } from './painter/frame.ts'
import type { DomainChange } from './protocol.ts'

/** The name of a circle. */
export interface Name {
  readonly id: number
  readonly text: string
}

/** Names in order of importance, and their circles. */
export interface Names {
  readonly list: readonly Name[]
  readonly circles: CircleTable
  readonly domain: Pick<DomainChange, 'lattice' | 'areSites'>
  /** The part of the plane where names are written. Default: everywhere. */
  readonly within?: Box | undefined
}

/** A name where it is written: the middle of the text. Lengths are in CSS pixels. */
export interface Label {
  readonly text: string
  readonly x: number
  readonly y: number
}

/** Height of the letters, and of a line with its margins. */
export const LABEL_SIZE = 12
const LINE = 15
/** Estimated widths of letters, relative to their height. All drawings have to choose the same labels. */
const LETTER = 0.6
const WIDE_LETTER = 1
const WIDE = /[\u1100-\u11ff\u2e80-\u9fff\uac00-\ud7af\uf900-\ufaff\uff00-\uff60\u{1f300}-\u{3ffff}]/u
const MARGIN = 6
/** Letters of the longest text; longer ones are cut. */
const LONGEST = 32
/** The largest number of labels in a frame, and the area for each one in CSS pixels if the frame is small. */
const MOST_LABELS = 100
const AREA = 5000
/** The largest number of names that are tried. */
const MOST_TRIED = 1000
/** Distance between the points of a text that have to be in its cell. */
const STEP = 10
/** The largest number of places for a text. */
const PLACES = 5
/** The circles that kept texts from their places in the last frame, by place. They are checked first in the next frame. */
const blockersOf = new WeakMap<CircleTable, Map<number, number>>()
/** Labels this far outside of a frame are placed too, so that those inside stay when the frame moves. */
const AROUND = 240

/**
 * Places names so that none overlaps another, none crosses the border of the frame, and each is in its cell: on its disc,
 * or below, above, to the right or to the left of it. Names that have no room are left out, the less important ones first.
 * `frame` is in CSS pixels. Cells end at `maxDistance` from their circles.
 */
export function placed({ list, circles, domain, within }: Names, frame: Frame, maxDistance = Infinity): Label[] {
  const { x, y, scale, width, height } = frame
  const blockers = blockersOf.get(circles) ?? new Map<number, number>()
  blockersOf.set(circles, blockers)
  const taken = new Taken()
  const labels: Label[] = []
  const most = Math.min(MOST_LABELS, Math.ceil((width * height) / AREA))
  const images = imagesOf(domain.lattice)
  let seen = 0
  let tried = 0
  for (const { id, text: whole } of list) {
    if (seen === most || tried === MOST_TRIED) break
    const circle = circles.get(id)
    if (circle === undefined) continue
    const [middleX, middleY] = [width / 2 + (circle.x - x) * scale, height / 2 - (circle.y - y) * scale]
    const isNear = (place: number, length: number) => place > -AROUND && place < length + AROUND
    if (!isNear(middleX, width) || !isNear(middleY, height)) continue
    tried += 1
    const text = shortened(whole)
    const half = widthOf(text) / 2 + MARGIN / 2
    const r = domain.areSites === true ? 0 : circle.r * scale
    const beside = [
      [0, r + LINE / 2 + 1],
      [0, -r - LINE / 2 - 1],
      [r + half, 0],
      [-r - half, 0],
    ] as const
    // A text would cover a point.
    const places = r < LINE ? beside : [[0, 0] as const, ...beside]
    const points = pointsOf(half)
    const isInCell = (dx: number, dy: number, key: number) => {
      const inPlane = (point: Point) => ({ x: circle.x + (dx + point.x) / scale, y: circle.y - (dy + point.y) / scale })
      const other = blockers.get(key)
      const isFree = points.every((offset) => {
        const point = inPlane(offset)
        const distance = circles.distanceTo(id, point)
        if (within !== undefined && !isIn(within, point)) return false
        return distance <= maxDistance && !(other !== undefined && circles.distanceTo(other, point) < distance)
      })
      if (!isFree) return false
      for (const offset of points) {
        const closer = circles.closerThan(id, inPlane(offset), images)
        if (closer === undefined) continue
        blockers.set(key, closer)
        return false
      }
      return true
    }
    const place = places.find(([dx, dy], k) => {
      const [textX, textY] = [middleX + dx, middleY + dy]
      if (isCut(textX, half, width) || isCut(textY, LINE / 2, height)) return false
      return taken.isFree(textX, textY, half) && isInCell(dx, dy, PLACES * id + k)
    })
    if (place === undefined) continue
    const label = { text, x: middleX + place[0], y: middleY + place[1] }
    taken.add(label.x, label.y, half)
    labels.push(label)
    if (label.x > 0 && label.x < width && label.y > 0 && label.y < height) seen += 1
  }
  return labels
}

function shortened(text: string): string {
  // A letter has at most two code units.
  const letters = [...text.slice(0, 2 * LONGEST + 1)]
  return letters.length > LONGEST ? `${letters.slice(0, LONGEST - 1).join('')}…` : text
}

/** Whether an end of the frame is within `half` of a text's middle. */
function isCut(middle: number, half: number, length: number): boolean {
  return Math.abs(middle) < half || Math.abs(middle - length) < half
}

function isIn({ minX, minY, maxX, maxY }: Box, { x, y }: Point): boolean {
  return x >= minX && x <= maxX && y >= minY && y <= maxY
}

/** The ends of a text and points of its upper and lower borders, relative to its middle. */
function pointsOf(half: number): Point[] {
  const steps = Math.ceil((2 * half) / STEP)
  const across = Array.from({ length: steps + 1 }, (_, k) => -half + (2 * half * k) / steps)
  const rows = [-LINE / 2, LINE / 2].flatMap((y) => across.map((x) => ({ x, y })))
  return [...rows, { x: -half, y: 0 }, { x: half, y: 0 }]
}

function widthOf(text: string): number {
  let width = 0
  for (const letter of text) width += WIDE.test(letter) ? WIDE_LETTER : LETTER
  return width * LABEL_SIZE
}

/** The boxes of labels, in rows as high as a line. */
class Taken {
  readonly #rows = new Map<number, (readonly [x: number, y: number, half: number])[]>()

  isFree(x: number, y: number, half: number): boolean {
    const row = Math.floor(y / LINE)
    return [row - 1, row, row + 1].every(
      (k) =>
        this.#rows
          .get(k)
          ?.every(([otherX, otherY, other]) => Math.abs(y - otherY) >= LINE || Math.abs(x - otherX) >= half + other) ??
        true,
    )
  }

  add(x: number, y: number, half: number): void {
    const row = Math.floor(y / LINE)
    this.#rows.set(row, [...(this.#rows.get(row) ?? []), [x, y, half]])
  }
}
