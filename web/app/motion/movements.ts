// SPDX-License-Identifier: GPL-3.0-or-later
// The animations. Each computes the circles of the next frame.

import type { IdentifiedCircle } from '../../editing/arranging.ts'
import type { Box } from '../../lib/index.ts'

/** Returns the circles `seconds` after the last frame. `neighbors` are pairs of ids whose cells share an edge. */
export type Movement = (seconds: number) => readonly IdentifiedCircle[]

export const MOVEMENTS = {
  bounce: 'Bounce',
  grow: 'Grow from points',
  compare: 'Compare three diagrams',
  breathe: 'Breathe',
} as const
export type MovementName = keyof typeof MOVEMENTS

/** Seconds in which a circle crosses the picture. */
const CROSSING = 8
/** Seconds in which radii grow from zero; also the time of one breath. */
const GROWING = 5
export const BREATH = 4
const BREADTH = 0.35

/** The animation with a name, for circles that bounce inside a box. */
export function movementOf(
  name: MovementName,
  circles: readonly IdentifiedCircle[],
  box: Box,
  random = Math.random,
): Movement {
  if (name === 'bounce') return bouncing(circles, box, random)
  let time = 0
  const scaledBy = (factorOf: (k: number) => number) =>
    circles.map(({ id, circle }, k) => ({ id, circle: { ...circle, r: circle.r * factorOf(k) } }))
  if (name === 'grow' || name === 'compare') {
    return (seconds) => {
      time += seconds
      // Oscillates between the ordinary Voronoi diagram of the centers and the diagram of the circles.
      const share = (1 - Math.cos((2 * Math.PI * time) / (2 * GROWING))) / 2
      return scaledBy(() => share)
    }
  }
  const phases = circles.map(() => 2 * Math.PI * random())
  return (seconds) => {
    time += seconds
    return scaledBy(
      (k) => 1 - BREADTH / 2 + (BREADTH / 2) * Math.cos((2 * Math.PI * time) / BREATH + (phases[k] as number)),
    )
  }
}

interface Ball {
  readonly id: number
  x: number
  y: number
  readonly r: number
  vx: number
  vy: number
}

/** Balls that bounce off each other and the walls of a box. Their masses are their areas. */
function bouncing(circles: readonly IdentifiedCircle[], box: Box, random: () => number): Movement {
  const speed = Math.max(box.maxX - box.minX, box.maxY - box.minY) / CROSSING
  const balls: Ball[] = circles.map(({ id, circle: { x, y, r } }) => {
    const angle = 2 * Math.PI * random()
    return { id, x, y, r, vx: speed * Math.cos(angle), vy: speed * Math.sin(angle) }
  })
  return (seconds) => {
    for (const [one, other] of nearPairs(balls)) bounce(one, other)
    for (const ball of balls) {
      ball.x += ball.vx * seconds
      ball.y += ball.vy * seconds
      // Reflects the ball at the walls.
      if (ball.x < box.minX + ball.r) ball.vx = Math.abs(ball.vx)
      if (ball.x > box.maxX - ball.r) ball.vx = -Math.abs(ball.vx)
      if (ball.y < box.minY + ball.r) ball.vy = Math.abs(ball.vy)
      if (ball.y > box.maxY - ball.r) ball.vy = -Math.abs(ball.vy)
    }
    return balls.map(({ id, x, y, r }) => ({ id, circle: { x, y, r } }))
  }
}

/** Pairs that may touch, by sweeping over the left ends. */
function* nearPairs(balls: readonly Ball[]): Generator<readonly [Ball, Ball]> {
  const sorted = [...balls].sort((one, other) => one.x - one.r - (other.x - other.r))
  for (const [k, one] of sorted.entries()) {
    for (let j = k + 1; j < sorted.length; j++) {
      const other = sorted[j] as Ball
      if (other.x - other.r > one.x + one.r) break
      if (Math.abs(one.y - other.y) <= one.r + other.r) yield [one, other]
    }
  }
}

/** An elastic collision of two touching balls that approach each other. */
function bounce(one: Ball, other: Ball): void {
  const [dx, dy] = [other.x - one.x, other.y - one.y]
  const distance = Math.hypot(dx, dy)
  if (distance === 0 || distance > one.r + other.r) return
  const nearing = ((one.vx - other.vx) * dx + (one.vy - other.vy) * dy) / distance
  if (nearing <= 0) return
  const [mass, otherMass] = [one.r ** 2, other.r ** 2]
  const all = mass + otherMass
  const [share, otherShare] = [otherMass / all, mass / all]
  one.vx -= (2 * share * nearing * dx) / distance
  one.vy -= (2 * share * nearing * dy) / distance
  other.vx += (2 * otherShare * nearing * dx) / distance
  other.vy += (2 * otherShare * nearing * dy) / distance
}
