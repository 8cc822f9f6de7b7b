// SPDX-License-Identifier: GPL-3.0-or-later
// A dense packing of discs of two sizes in a box whose opposite sides are glued together. The discs grow; where two
// overlap, they move apart. The neighbors come from the table of contacts.

/** The largest gap between touching discs, as a share of the mean radius. */
const TOUCH = 0.02
const GROWTH = 1.02
const LEAST_GROWTH = 1.0005
/** The overlap at which discs grow again, as a share of their growth. */
const SLACK = 0.5
/** Overlapping discs move by this multiple of the necessary distance, so that their neighbors settle sooner. */
const PUSH = 1.5
/** Discs grow more slowly after this many steps without room. */
const PATIENCE = 100
const STEPS = 3000

/**
 * @param library the result of loadCircleVoronoi
 * @param lattice the periods of the box
 * @param ratio the ratio of the two radii
 * @param random returns numbers from 0 to 1
 */
export function pack(library, lattice, count, ratio, random) {
  const { a, b } = lattice
  const area = Math.abs(a[0] * b[1] - a[1] * b[0])
  // At the start, the discs cover two fifths of the box.
  let radius = Math.sqrt((0.4 * area) / (Math.PI * (count / 2) * (1 + ratio ** 2)))
  let growth = GROWTH
  let waiting = 0
  const circles = Array.from({ length: count }, () => {
    const [u, v] = [random(), random()]
    return { x: u * a[0] + v * b[0], y: u * a[1] + v * b[1], r: 0 }
  })
  const resize = () => {
    for (const [i, circle] of circles.entries()) circle.r = i % 2 === 0 ? radius : ratio * radius
  }
  for (let step = 0; step < STEPS && growth > LEAST_GROWTH; step++) {
    resize()
    const overlap = separate(circles, lattice, library.computePeriodic(circles, lattice))
    if (overlap < SLACK * (growth - 1) * radius) {
      radius *= growth
      waiting = 0
    } else if (++waiting === PATIENCE) {
      // There is no room for this growth, so undo it and continue with smaller steps.
      radius /= growth
      growth = 1 + (growth - 1) / 2
      waiting = 0
    }
  }
  // Remove the remaining overlaps.
  resize()
  const { gaps } = library.computePeriodic(circles, lattice).contacts()
  radius += Math.min(0, ...gaps) / 2
  resize()
  return library.computePeriodic(circles, lattice)
}

/** Moves overlapping discs apart and returns the largest overlap. */
function separate(circles, { a, b }, periodic) {
  const { contacts, gaps } = periodic.contacts()
  gaps.forEach((gap, k) => {
    const [i, j, s, t] = contacts.subarray(4 * k, 4 * k + 4)
    // Each contact is in the table twice.
    if (gap >= 0) return
    const { circles: places } = periodic.diagram
    const dx = places[3 * j] + s * a[0] + t * b[0] - places[3 * i]
    const dy = places[3 * j + 1] + s * a[1] + t * b[1] - places[3 * i + 1]
    const distance = Math.sqrt(dx * dx + dy * dy)
    circles[i].x += ((PUSH * gap) / 2) * (dx / distance)
    circles[i].y += ((PUSH * gap) / 2) * (dy / distance)
  })
  return -Math.min(0, ...gaps)
}

/** Returns each pair of touching discs once: two discs, and the shift of the second. */
export function touching(periodic) {
  const { contacts, gaps } = periodic.contacts()
  const { circles } = periodic.diagram
  const radii = Array.from({ length: periodic.circleCount }, (_, i) => circles[3 * i + 2])
  const mean = radii.reduce((sum, r) => sum + r, 0) / radii.length
  return Array.from(gaps.keys())
    .filter((k) => gaps[k] <= TOUCH * mean)
    .map((k) => [...contacts.subarray(4 * k, 4 * k + 4)])
    .filter(([i, j, s, t]) => i < j || (i === j && (s > 0 || (s === 0 && t > 0))))
}
