// SPDX-License-Identifier: GPL-3.0-or-later
import type { ErrorCode } from '../lib/base/errors.ts'
import { ENGLISH_REFUSALS, listed, Refusal } from '../view/refusal.ts'

/** Error messages about a page's input. */
export const ENGLISH = {
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
  /** Lists the allowed words, of which any number may be given. */
  someOf: (words: readonly string[]) => `${listed(words, 'or')}, or both`,
  notJson: (what: string, reason: string) => `${what} are not valid JSON: ${reason}.`,
  view: 'A view is three numbers: x, y and a span above 0.',
  step: (got: string) => `A step is a whole number from 0, not ${got}.`,
  check: (reason: string) => `The check cannot be read: ${reason}.`,
  checkParts: 'it has too many parts',
  checkObject: 'each part is an object',
  checkNothing: 'a part says nothing',
  checkNotJson: 'it is not valid JSON',
  checkNoCell: 'it says nothing of the cell',
  checkAlone: (name: string) => `${name} stands alone`,
  checkList: (name: string) => `${name} has a list`,
  checkCircle: (name: string) => `${name} is the id of a circle`,
  checkFlag: (name: string) => `${name} is true or false`,
  checkCondition: (name: string) => `${name} is a number, or an object with min and max`,
  checkName: (isOfCell: boolean, name: string, known: readonly string[]) =>
    `${isOfCell ? 'a cell' : 'a diagram'} has no ${name}; it has ${listed(known, 'and')}`,
  /** `count` is the number of ids ever assigned. */
  checkMissing: (circle: number, count: number) =>
    `there is no circle ${circle}. ${count === 0 ? 'There are no circles' : `The circles have the ids 0 to ${count - 1}`}`,
  line: (k: number) => `Line ${k}`,
  row: (k: number) => `Row ${k} of the table`,
  notThree: (place: string, fields: string) => `${place} is not three numbers x, y and r: ${fields}`,
  notCircle: (index: number) => `Circle ${index} does not have three numbers x, y and r.`,
  noCircles: 'There are no circles in this.',
  notLoaded: (src: string, status: number) => `${src} cannot be loaded: the answer is ${status}.`,
  within: (src: string, sentence: string) => `${src}: ${sentence}`,
  dataSet: (name: string) =>
    `The link names the data set ${name} of the page it is from, and has no circles of its own.`,
  notInPage: 'The figure is in no page, or no longer.',
  notComputedAgain: 'The diagram could not be computed. Try again.',
}

export type ElementRefusals = typeof ENGLISH

/** @throws Refusal */
export function refuse(say: (words: ElementRefusals) => string, code?: ErrorCode): never {
  throw new Refusal(ENGLISH, say, code)
}
