// SPDX-License-Identifier: GPL-3.0-or-later
import type { ErrorCode } from '../lib/base/errors.ts'
import { ENGLISH_REFUSALS, listed, Refusal, type Refusals } from '../view/refusal.ts'

/** Error messages about a page's input, in one language. */
export interface ElementRefusals extends Refusals {
  readonly circles: string
  readonly method: string
  readonly controls: string
  readonly samples: string
  readonly lattice: string
  readonly twoPeriods: string
  readonly areas: string
  readonly sharesOrEqual: string
  readonly selection: string
  readonly listOfIds: string
  /** Lists the allowed words, of which any number may be given. */
  someOf(words: readonly string[]): string
  notJson(what: string, reason: string): string
  readonly view: string
  step(got: string): string
  check(reason: string): string
  readonly checkParts: string
  readonly checkObject: string
  readonly checkNothing: string
  readonly checkNotJson: string
  readonly checkNoCell: string
  checkAlone(name: string): string
  checkList(name: string): string
  checkCircle(name: string): string
  checkFlag(name: string): string
  checkCondition(name: string): string
  checkName(isOfCell: boolean, name: string, known: readonly string[]): string
  /** `count` is the number of ids ever assigned. */
  checkMissing(circle: number, count: number): string
  line(k: number): string
  row(k: number): string
  notThree(place: string, fields: string): string
  notCircle(index: number): string
  readonly noCircles: string
  notLoaded(src: string, status: number): string
  within(src: string, sentence: string): string
  dataSet(name: string): string
  readonly notInPage: string
  readonly notComputedAgain: string
}

export const ENGLISH: ElementRefusals = {
  ...ENGLISH_REFUSALS,
  circles: 'The circles',
  method: 'The method',
  controls: 'The controls',
  samples: 'The samples',
  lattice: 'The lattice',
  twoPeriods: 'two periods, four numbers ax ay bx by',
  areas: 'The areas',
  sharesOrEqual: 'equal, or a list of numbers above 0',
  selection: 'The selection',
  listOfIds: 'a list of circle ids',
  someOf: (words) => `${listed(words, 'or')}, or both`,
  notJson: (what, reason) => `${what} are not valid JSON: ${reason}.`,
  view: 'A view is three numbers: x, y and a span above 0.',
  step: (got) => `A step is a whole number from 0, not ${got}.`,
  check: (reason) => `The check cannot be read: ${reason}.`,
  checkParts: 'it has too many parts',
  checkObject: 'each part is an object',
  checkNothing: 'a part says nothing',
  checkNotJson: 'it is not valid JSON',
  checkNoCell: 'it says nothing of the cell',
  checkAlone: (name) => `${name} stands alone`,
  checkList: (name) => `${name} has a list`,
  checkCircle: (name) => `${name} is the id of a circle`,
  checkFlag: (name) => `${name} is true or false`,
  checkCondition: (name) => `${name} is a number, or an object with min and max`,
  checkName: (isOfCell, name, known) =>
    `${isOfCell ? 'a cell' : 'a diagram'} has no ${name}; it has ${listed(known, 'and')}`,
  checkMissing: (circle, count) =>
    `there is no circle ${circle}. ${count === 0 ? 'There are no circles' : `The circles have the ids 0 to ${count - 1}`}`,
  line: (k) => `Line ${k}`,
  row: (k) => `Row ${k} of the table`,
  notThree: (place, fields) => `${place} is not three numbers x, y and r: ${fields}`,
  notCircle: (index) => `Circle ${index} does not have three numbers x, y and r.`,
  noCircles: 'There are no circles in this.',
  notLoaded: (src, status) => `${src} cannot be loaded: the answer is ${status}.`,
  within: (src, sentence) => `${src}: ${sentence}`,
  dataSet: (name) => `The link names the data set ${name} of the page it is from, and has no circles of its own.`,
  notInPage: 'The figure is in no page, or no longer.',
  notComputedAgain: 'The diagram could not be computed. Try again.',
}

/** @throws Refusal */
export function refuse(say: (words: ElementRefusals) => string, code?: ErrorCode): never {
  throw new Refusal(ENGLISH, say, code)
}
