// SPDX-License-Identifier: GPL-3.0-or-later
// Random circles for property tests, each kind named for what it shows.
import fc from 'fast-check'
import type { Edit } from '../../web/lib/index.ts'

type Circle = readonly [number, number, number]

/** Numbers with six decimal places. They shrink quickly, and never to tiny values. */
function numbers(min: number, max: number): fc.Arbitrary<number> {
  return fc.integer({ min: Math.round(min * 1e6), max: Math.round(max * 1e6) }).map((value) => value / 1e6)
}

/** Numbers from 0 to 1. */
export const unit: fc.Arbitrary<number> = numbers(0, 1)
const coordinate = numbers(-100, 100)
const MOST = 24

function circles(circle: fc.Arbitrary<Circle>, minLength = 1): fc.Arbitrary<Float64Array> {
  return fc.array(circle, { minLength, maxLength: MOST }).map((list) => Float64Array.from(list.flat()))
}

const intersecting = circles(fc.tuple(coordinate, coordinate, numbers(0, 40)))

/** Shrinks each circle until it meets none before it. */
const disjoint = intersecting.map((flat) => {
  for (let i = 0; i < flat.length; i += 3) {
    for (let j = 0; j < i; j += 3) {
      const [x, y, r] = [0, 1, 2].map((k) => flat[j + k] as number) as [number, number, number]
      const room = Math.hypot((flat[i] as number) - x, (flat[i + 1] as number) - y) - r
      flat[i + 2] = Math.min(flat[i + 2] as number, Math.max(room, 0) * 0.9)
    }
  }
  return flat
})

/** Circles inside circles, some of which touch from inside. */
const nested = fc
  .array(fc.tuple(coordinate, coordinate, numbers(1, 40), unit, unit, unit), {
    minLength: 1,
    maxLength: MOST / 2,
  })
  .map((list) =>
    Float64Array.from(
      list.flatMap(([x, y, r, turn, share, place]) => {
        const inner = r * share
        const offset = (r - inner) * (place > 0.5 ? 1 : place)
        return [x, y, r, x + offset * Math.cos(7 * turn), y + offset * Math.sin(7 * turn), inner]
      }),
    ),
  )

/** Circles of radius 1 in rows, most of which touch each other, so that every vertex is degenerate. */
const tangent = circles(
  fc.tuple(fc.integer({ min: -3, max: 3 }), fc.integer({ min: -3, max: 3 })).map(([x, y]) => [2 * x, 2 * y, 1]),
)

const equalRadii = fc
  .tuple(circles(fc.tuple(coordinate, coordinate, fc.constant(0))), numbers(0, 20))
  .map(([flat, radius]) => flat.map((value, k) => (k % 3 === 2 ? radius : value)))

const points = circles(fc.tuple(coordinate, coordinate, fc.constant(0)))

/** Small circles around and inside a much larger one. */
const oneHuge = fc.tuple(disjoint, numbers(1e2, 1e6), unit).map(([flat, radius, turn]) => {
  const distance = radius + 30
  return Float64Array.of(...flat, distance * Math.cos(7 * turn), distance * Math.sin(7 * turn), radius)
})

const integers = circles(
  fc.tuple(fc.integer({ min: -6, max: 6 }), fc.integer({ min: -6, max: 6 }), fc.integer({ min: 0, max: 3 })),
)

/** Kinds of circles as flat arrays of x, y, r, with up to about two dozen circles. */
export const KINDS = { disjoint, intersecting, nested, tangent, equalRadii, points, oneHuge, integers } as const

/** Circles of any kind. */
export const anyCircles: fc.Arbitrary<Float64Array> = fc.oneof(...Object.values(KINDS))

/** Two circles of which neither contains the other, from equal radii to one almost inside the other. */
export const circlePair: fc.Arbitrary<Float64Array> = fc
  .record({
    x: coordinate,
    y: coordinate,
    turn: unit,
    distance: numbers(1e-3, 100),
    // The lean is (r_left - r_right) / distance.
    lean: fc.oneof(fc.constantFrom(0, 1e-12, -1e-12, 1 - 1e-9, 1e-9 - 1), numbers(-0.999, 0.999)),
    smaller: numbers(0, 50),
  })
  .map(({ x, y, turn, distance, lean, smaller }) => {
    const left = smaller + Math.max(0, lean) * distance
    const right = smaller + Math.max(0, -lean) * distance
    return Float64Array.of(x, y, left, x + distance * Math.cos(7 * turn), y + distance * Math.sin(7 * turn), right)
  })

/** An action of a script, which is told apart from others by its kind. */
export function action<Kind extends string, More extends object = object>(
  kind: Kind,
  more: { [Name in keyof More]: fc.Arbitrary<More[Name]> } = {} as never,
): fc.Arbitrary<{ kind: Kind } & More> {
  return fc.record({ kind: fc.constant(kind), ...more }) as fc.Arbitrary<{ kind: Kind } & More>
}

/** Edits of circles, of which some may have no circle. */
export function editOf<Circle extends Extract<Edit, { kind: 'insert' }>['circle']>(
  circle: fc.Arbitrary<Circle>,
  id: fc.Arbitrary<number> = fc.nat(9),
): fc.Arbitrary<Edit> {
  return fc.oneof(action('insert', { circle }), action('remove', { id }), action('replace', { id, circle }))
}
