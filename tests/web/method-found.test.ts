// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, it } from 'vitest'
import { saidOf } from '../../web/app/panels/method-found.ts'

it('says of a method what it finds of all there is, and what is wrong', () => {
  expect(
    saidOf({
      vertices: { all: 1200, found: 1198, wrong: 1 },
      edges: { all: 50, found: 48, wrong: 3 },
      samples: 7000,
    } as never),
  ).toBe(
    'From 7,000 samples the method finds 1,198 of 1,200 vertices and 48 of 50 edges, and 1 wrong vertex and 3 wrong edges. What is shown stays certified.',
  )
  expect(
    saidOf({ vertices: { all: 2, found: 2, wrong: 2 }, edges: { all: 3, found: 3, wrong: 1 }, samples: 0 } as never),
  ).toContain(
    'From all pairs the method finds 2 of 2 vertices and 3 of 3 edges, and 2 wrong vertices and 1 wrong edge.',
  )
  expect(
    saidOf({ vertices: { all: 2, found: 2, wrong: 0 }, edges: { all: 3, found: 3, wrong: 0 }, samples: 5 } as never),
  ).toContain('and nothing that is wrong.')
})
