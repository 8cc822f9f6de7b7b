// SPDX-License-Identifier: GPL-3.0-or-later

import { at, NONE } from '../base/diagram-data.ts'
import type { DiagramData, Int32s } from '../base/types.ts'

type Adjacency = Pick<DiagramData, 'nextSide' | 'vertexSides' | 'firstSide'>
type Parts = Pick<DiagramData, 'circles' | 'vertexCircles' | 'edges' | 'hull'>

/**
 * Links the sides of a diagram by its vertices, edges and hull, whose indices are in range. If these do not fit
 * together, no side has a next side, and `certify` names the flaw.
 */
export function linkSides(parts: Parts): Adjacency {
  const adjacency = unlinked(parts)
  return linkAtVertices(parts, adjacency) && linkAtInfinity(parts, adjacency)
    ? { ...adjacency, firstSide: firstSidesOf(parts) }
    : unlinked(parts)
}

function unlinked({ circles, vertexCircles, edges }: Parts): Adjacency {
  return {
    nextSide: new Int32Array(edges.length / 2).fill(NONE),
    vertexSides: new Int32Array(vertexCircles.length).fill(NONE),
    firstSide: new Int32Array(circles.length / 3).fill(NONE),
  }
}

function circleOf({ edges }: Parts, side: number): number {
  return at(edges, 4 * (side >> 1) + (side & 1))
}

function originOf({ edges }: Parts, side: number): number {
  return at(edges, 4 * (side >> 1) + 2 + (side & 1))
}

/** Returns the place before `slot` among the three circles of a vertex, counter-clockwise. */
export function before(slot: number): number {
  return slot % 3 === 0 ? slot + 2 : slot - 1
}

/**
 * Links the sides at vertices. A side that leaves a vertex has its own circle on the left and the previous circle of
 * the vertex on the right.
 */
function linkAtVertices(parts: Parts, { nextSide, vertexSides }: Adjacency): boolean {
  const { vertexCircles } = parts
  for (let side = 0; side < nextSide.length; side++) {
    const origin = originOf(parts, side)
    if (origin === NONE) continue
    const corner = vertexCircles.subarray(3 * origin, 3 * origin + 3).indexOf(circleOf(parts, side))
    const slot = 3 * origin + corner
    if (corner < 0 || vertexSides[slot] !== NONE) return false
    if (vertexCircles[before(slot)] !== circleOf(parts, side ^ 1)) return false
    vertexSides[slot] = side
  }
  if (vertexSides.includes(NONE)) return false
  vertexSides.forEach((side, slot) => {
    nextSide[side ^ 1] = at(vertexSides, before(slot))
  })
  return true
}

/**
 * Links the sides at infinity. For each step of the hull from i to j, one side of circle i next to circle j begins at
 * infinity, and its twin ends there. Each step occurs once.
 */
function linkAtInfinity(parts: Parts, { nextSide }: Adjacency): boolean {
  const { circles, hull } = parts
  const step = (from: number, to: number) => (from * circles.length) / 3 + to
  const fromInfinity = new Map<number, number>()
  let count = 0
  for (let side = 0; side < nextSide.length; side++) {
    if (originOf(parts, side) !== NONE) continue
    fromInfinity.set(step(circleOf(parts, side), circleOf(parts, side ^ 1)), side)
    count += 1
  }
  const steps = hull.length > 1 ? hull.length : 0
  if (count !== steps) return false
  const sideOfStep = (k: number) => fromInfinity.get(step(at(hull, k % steps), at(hull, (k + 1) % steps)))
  for (let k = 0; k < steps; k++) {
    const side = sideOfStep(k)
    const next = sideOfStep(k + 1)
    if (side === undefined || next === undefined || nextSide[side ^ 1] !== NONE) return false
    nextSide[side ^ 1] = next
  }
  return true
}

function firstSidesOf(parts: Parts): Int32s {
  const { circles, edges } = parts
  const firstSide = new Int32Array(circles.length / 3).fill(NONE)
  for (let side = edges.length / 2 - 1; side >= 0; side--) firstSide[circleOf(parts, side)] = side
  return firstSide
}
