// SPDX-License-Identifier: GPL-3.0-or-later
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import {
  type Condition,
  checkOf,
  comparisonsOf,
  conditionsOf,
  KINDS,
  kindOf,
  newCondition,
  sentenceOf,
} from '../../web/app/question/conditions.ts'
import { parseCheck } from '../../web/element/check.ts'

const condition: fc.Arbitrary<Condition> = fc
  .record({ kind: fc.constantFrom(...KINDS.map(({ key }) => key)), circle: fc.nat(9), which: fc.nat(3) })
  .chain(({ kind, circle, which }) => {
    const allowed = comparisonsOf(kindOf({ kind }))
    return fc.record({
      kind: fc.constant(kind),
      circle: fc.constant(circle),
      comparison: fc.constant(allowed[which % allowed.length] as Condition['comparison']),
      value: fc.nat(20),
      most: fc.nat(20),
      flag: fc.boolean(),
      other: fc.nat(9),
    })
  })

describe('the conditions of a question', () => {
  it('make a check that the element takes, which gives the conditions back', () => {
    fc.assert(
      fc.property(fc.array(condition, { minLength: 1, maxLength: 4 }), fc.boolean(), (conditions, isAny) => {
        const check = checkOf(conditions, isAny)
        expect(parseCheck(JSON.stringify(check))).toEqual(check)
        const back = conditionsOf(check as NonNullable<typeof check>)
        expect(back && checkOf(back.conditions, back.isAny)).toEqual(check)
        if (conditions.length > 1) expect(back?.isAny).toBe(isAny)
      }),
    )
  })

  it('between two numbers are the same in either order', () => {
    const between = (value: number, most: number) =>
      checkOf([{ ...newCondition(0), kind: 'cell.edges', comparison: 'between', value, most }], false)
    expect([between(5, 2), between(2, 5)]).toEqual(Array(2).fill({ cell: 0, edges: { min: 2, max: 5 } }))
  })

  it('are those of a cell with several properties, and of no check with parts in one another', () => {
    expect(conditionsOf({ cell: 4, edges: 3, bounded: true })?.conditions).toMatchObject([
      { kind: 'cell.edges', circle: 4, comparison: 'is', value: 3 },
      { kind: 'cell.bounded', circle: 4, flag: true },
    ])
    expect(conditionsOf({ not: { circles: 3 } })).toBeUndefined()
    expect(conditionsOf({ all: [{ any: [{ circles: 3 }] }] })).toBeUndefined()
    expect(conditionsOf({ any: [{ cell: 1, edges: 3, bounded: true }, { circles: 3 }] })).toBeUndefined()
    expect(checkOf([], false)).toBeUndefined()
    const ownCheck = { any: [{ circles: 3 }, { all: [{ edges: 2 }, { hidden: 1 }] }] }
    expect(checkOf([], false, ownCheck)).toBe(ownCheck)
    const condition = { ...newCondition(0), kind: 'cell.edges', comparison: 'min', value: 1 } as const
    for (const [isAny, name] of [
      [true, 'any'],
      [false, 'all'],
    ] as const) {
      expect(checkOf([condition], isAny, ownCheck)).toEqual({ [name]: [ownCheck, { cell: 0, edges: { min: 1 } }] })
    }
  })

  it('are asked for in a sentence with their numbers, in English and in German', () => {
    for (const { key } of KINDS) {
      for (const lang of ['en', 'de']) {
        const sentence = sentenceOf([{ ...newCondition(4), value: 3, kind: key }], false, lang)
        expect(sentence).toMatch(/^\p{Lu}.*\d.*\.$/u)
        expect(sentence).not.toContain('undef')
      }
    }
  })
})
