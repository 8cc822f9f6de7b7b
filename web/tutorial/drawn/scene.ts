// SPDX-License-Identifier: GPL-3.0-or-later
// Shared code of the figures that the tutorial draws itself: circles in a frame, as SVG.
import { escaped } from '../../lib/drawing/escaped.ts'
import type { Circle, CircleVoronoi, Diagram, Float64s, Point } from '../../lib/index.ts'
import type { RegionShape } from '../../lib/regions/region-shape.ts'
import type { Regions } from '../../lib/wasm/regions.ts'

/** The contents of a figure, in the units of its circles. */
export interface Scene {
  readonly circles: readonly Circle[]
  /** A draggable point. */
  readonly point: Point | undefined
  /** x and y of the middle, and the width. */
  readonly view: readonly [x: number, y: number, width: number]
  /** The region that cells are clipped to. */
  readonly region?: RegionShape | undefined
}

export interface Drawing {
  /** The markup between the tags of the SVG. */
  readonly content: string
  /** The caption below the figure. */
  readonly told: string
}

/** A kind of figure: a slider and the picture at each of its values. */
export interface Kind {
  /** Height of the picture. Default: `HEIGHT`. */
  readonly height?: number
  /** Whether the figure needs the module of regions. */
  readonly hasRegions?: boolean
  /** The range of the slider. It starts at 0 and has steps of 1 if its values are events. */
  range(
    scene: Scene,
    library: CircleVoronoi,
    regions?: Regions,
  ): { readonly last: number; readonly step: number | 'any' }
  draw(scene: Scene, value: number, library: CircleVoronoi, regions?: Regions): Drawing
  /** A point that readers can drag too, in place of the slider: its place at a value, and the value nearest to a place. */
  readonly grip?: {
    at(scene: Scene, value: number): Point
    valueAt(scene: Scene, place: Point): number
  }
}

export const WIDTH = 640
export const HEIGHT = 400

/** Collects the SVG of a scene. Lines use coordinates of the plane (y-up), text uses coordinates of the picture. */
export class Pen {
  readonly #scale: number
  readonly #middle: Point
  readonly #plane: string[] = []
  readonly #words: string[] = []
  readonly #height: number
  readonly bounds: readonly [minX: number, minY: number, maxX: number, maxY: number]

  constructor({ view: [x, y, width] }: Scene, height = HEIGHT) {
    this.#scale = WIDTH / width
    this.#middle = { x, y }
    this.#height = height
    const [halfX, halfY] = [width / 2, height / 2 / this.#scale]
    this.bounds = [x - halfX, y - halfY, x + halfX, y + halfY]
  }

  /** Converts pixels of the picture to units of the plane. */
  units(pixels: number): number {
    return pixels / this.#scale
  }

  path(names: string, d: string): this {
    if (d !== '') this.#plane.push(`<path class="${names}" d="${d}"/>`)
    return this
  }

  disc(names: string, { x, y, r }: Circle): this {
    this.#plane.push(`<circle class="${names}" cx="${short(x)}" cy="${short(y)}" r="${short(Math.abs(r))}"/>`)
    return this
  }

  line(names: string, from: Point, to: Point): this {
    return this.path(names, `M${at(from)}L${at(to)}`)
  }

  /** Segments: x, y of one end, x, y of the other. */
  segments(names: string, ends: ArrayLike<number>): this {
    let d = ''
    for (let k = 0; k < ends.length; k += 4) {
      const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] = [ends[k], ends[k + 1], ends[k + 2], ends[k + 3]]
      d += `M${at({ x: x0, y: y0 })}L${at({ x: x1, y: y1 })}`
    }
    return this.path(names, d)
  }

  /** An arrow, offset to the right of the straight line. */
  arrow(names: string, from: Point, to: Point, aside = 0): this {
    const [dx, dy] = [to.x - from.x, to.y - from.y]
    const length = Math.hypot(dx, dy)
    if (length === 0) return this
    const [ux, uy] = [dx / length, dy / length]
    const shift = this.units(aside)
    const [sx, sy] = [uy * shift, -ux * shift]
    const tip = { x: to.x + sx, y: to.y + sy }
    const head = Math.min(this.units(11), 0.6 * length)
    const wing = (side: number) => ({
      x: tip.x - head * (ux + side * 0.5 * uy),
      y: tip.y - head * (uy - side * 0.5 * ux),
    })
    return this.path(
      names,
      `M${at({ x: from.x + sx, y: from.y + sy })}L${at(tip)}M${at(wing(1))}L${at(tip)}L${at(wing(-1))}`,
    )
  }

  dot(names: string, { x, y }: Point, pixels: number): this {
    return this.disc(`dot ${names}`, { x, y, r: this.units(pixels) })
  }

  write(names: string, { x, y }: Point, text: string, anchor: 'start' | 'middle' | 'end' = 'middle'): this {
    const [px, py] = [
      WIDTH / 2 + (x - this.#middle.x) * this.#scale,
      this.#height / 2 - (y - this.#middle.y) * this.#scale,
    ]
    this.#words.push(
      `<text class="${names}" x="${px.toFixed(1)}" y="${py.toFixed(1)}" text-anchor="${anchor}">${escaped(text)}</text>`,
    )
    return this
  }

  /** Adds SVG in units of the picture. */
  raw(svg: string): this {
    this.#words.push(svg)
    return this
  }

  get content(): string {
    const transform = `matrix(${this.#scale} 0 0 ${-this.#scale} ${WIDTH / 2 - this.#middle.x * this.#scale} ${
      this.#height / 2 + this.#middle.y * this.#scale
    })`
    return `<g class="plane" transform="${transform}">${this.#plane.join('')}</g>${this.#words.join('')}`
  }
}

/** Draws the cells in the colors of their circles, and the edges. */
export function drawCells(pen: Pen, diagram: Diagram, colors = colorsOf(diagram)): void {
  const options = { bounds: [...pen.bounds] as [number, number, number, number] }
  for (let i = 0; i < diagram.circles.length / 3; i++) pen.path(`cell c${colors[i]}`, diagram.cellPath(i, options))
  pen.path('edge', diagram.render(options))
}

export function drawDiscs(pen: Pen, circles: readonly Circle[], colors: readonly number[], hasNumbers = true): void {
  for (const [i, circle] of circles.entries()) {
    pen.disc(`disc c${colors[i]}`, { ...circle, r: Math.max(circle.r, pen.units(3)) })
    const isRoomy = circle.r > pen.units(12)
    if (hasNumbers)
      pen.write(
        isRoomy ? 'number inside' : 'number',
        isRoomy ? circle : { x: circle.x + circle.r + pen.units(9), y: circle.y + circle.r + pen.units(3) },
        `${i}`,
      )
  }
}

/** Colors cells greedily with six colors. Neighbors differ unless all six colors are taken. */
export function colorsOf(diagram: Diagram): readonly number[] {
  const count = diagram.circles.length / 3
  if (count <= 6) return Array.from({ length: count }, (_, i) => i)
  const colors: number[] = []
  for (let i = 0; i < count; i++) {
    const taken = new Set([...diagram.neighbors(i)].map((other) => colors[other]))
    const usable = [0, 1, 2, 3, 4, 5].map((k) => (k + i) % 6)
    colors[i] = usable.find((color) => !taken.has(color)) ?? i % 6
  }
  return colors
}

export function coordinatesOf(circles: readonly Circle[]): Float64s {
  return Float64Array.from(circles.flatMap(({ x, y, r }) => [x, y, r]))
}

/** The distance from a point to a rim, negative inside the circle. */
export function distance({ x, y, r }: Circle, point: Point): number {
  return Math.hypot(point.x - x, point.y - y) - r
}

/** The circle nearest to a point. */
export function nearest(circles: readonly Circle[], point: Point): number {
  const distances = circles.map((circle) => distance(circle, point))
  return distances.indexOf(Math.min(...distances))
}

/** The point of a rim in the direction of another point. */
export function footOf({ x, y, r }: Circle, point: Point): Point {
  const [dx, dy] = [point.x - x, point.y - y]
  const length = Math.hypot(dx, dy)
  return length === 0 ? { x: x + r, y } : { x: x + (dx / length) * r, y: y + (dy / length) * r }
}

/** Formats a number for readers. */
export function said(value: number): string {
  return `${Number(value.toFixed(2))}`.replace('-', '−')
}

/** Joins items as in "0, 1 and 2". */
export function list(items: readonly (number | string)[]): string {
  return items.length < 2 ? items.join('') : `${items.slice(0, -1).join(', ')} and ${items.at(-1)}`
}

function at({ x, y }: Point): string {
  return `${short(x)},${short(y)}`
}

function short(value: number): string {
  return `${Number(value.toFixed(3))}`
}
