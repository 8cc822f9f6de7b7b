// SPDX-License-Identifier: GPL-3.0-or-later
import type { Circle } from '../lib/index.ts'
import type { Frame } from './painter/frame.ts'

/** The name of a circle. */
export interface Name {
  readonly id: number
  readonly text: string
}

/** Names in order of importance, and where their circles are. */
export interface Names {
  readonly list: readonly Name[]
  circleOf(id: number): Circle | undefined
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
/** A longer text is cut. */
const LONGEST = 32
/** The largest number of labels in a frame, and the largest number of names that are tried. */
const MOST_LABELS = 400
const MOST_TRIED = 20_000
/** Labels this far outside of a frame are placed too, so that those inside stay when the frame moves. */
const AROUND = 240

/**
 * Places names so that none overlaps another: inside its disc, or else below, above, to the right or to the left of it.
 * Names that have no room are left out, the less important ones first. `frame` is in CSS pixels.
 */
export function placed({ list, circleOf }: Names, { x, y, scale, width, height }: Frame): Label[] {
  const taken = new Taken()
  const labels: Label[] = []
  let tried = 0
  for (const { id, text: whole } of list) {
    if (labels.length === MOST_LABELS || tried === MOST_TRIED) break
    const circle = circleOf(id)
    if (circle === undefined) continue
    const [middleX, middleY] = [width / 2 + (circle.x - x) * scale, height / 2 - (circle.y - y) * scale]
    const isNear = (place: number, length: number) => place > -AROUND && place < length + AROUND
    if (!isNear(middleX, width) || !isNear(middleY, height)) continue
    tried += 1
    const text = whole.length > LONGEST ? `${whole.slice(0, LONGEST - 1)}…` : whole
    const half = widthOf(text) / 2 + MARGIN / 2
    const r = circle.r * scale
    const isInside = half * half + (LINE / 2) ** 2 < r * r
    const places = isInside
      ? [[0, 0] as const]
      : ([
          [0, r + LINE / 2 + 1],
          [0, -r - LINE / 2 - 1],
          [r + half, 0],
          [-r - half, 0],
        ] as const)
    const place = places.find(([dx, dy]) => taken.add(middleX + dx, middleY + dy, half))
    if (place !== undefined) labels.push({ text, x: middleX + place[0], y: middleY + place[1] })
  }
  return labels
}

function widthOf(text: string): number {
  let width = 0
  for (const letter of text) width += WIDE.test(letter) ? WIDE_LETTER : LETTER
  return width * LABEL_SIZE
}

/** The boxes of labels, in rows as high as a line. */
class Taken {
  readonly #rows = new Map<number, (readonly [x: number, y: number, half: number])[]>()

  /** Takes the place of a text if it is free. */
  add(x: number, y: number, half: number): boolean {
    const row = Math.floor(y / LINE)
    for (let k = row - 1; k <= row + 1; k++) {
      const isTaken = this.#rows
        .get(k)
        ?.some(([otherX, otherY, other]) => Math.abs(y - otherY) < LINE && Math.abs(x - otherX) < half + other)
      if (isTaken === true) return false
    }
    const own = this.#rows.get(row)
    if (own === undefined) this.#rows.set(row, [[x, y, half]])
    else own.push([x, y, half])
    return true
  }
}
