// SPDX-License-Identifier: GPL-3.0-or-later
import { CircleVoronoiError, type ErrorCode } from '../lib/base/errors.ts'

/** Joins names as a list, with the word `last` before the last one: `a, b or c`. */
export function listed(names: readonly string[], last: string): string {
  return names.length < 2 ? names.join('') : `${names.slice(0, -1).join(', ')} ${last} ${names.at(-1)}`
}

/** Error messages. */
export const ENGLISH_REFUSALS = {
  /** `got` is formatted by `shownValue`. */
  must: (what: string, allowed: string, got: string) => `${what} must be ${allowed} (got ${got}).`,
  layers: 'The layers',
  object: 'an object',
  layer: (name: string) => `The layer ${name}`,
  oneOf: (values: readonly string[]) => listed(values, 'or'),
  wholeNumber: (least: number, most?: number) =>
    `a whole number from ${least}${most === undefined ? '' : ` to ${most}`}`,
  trueOrFalse: 'true or false',
  number: 'a number',
  numberFromZero: 'a number from 0',
  path: 'two points { from: { x, y }, to: { x, y } }',
  data: 'an array of objects whose points, segments and discs are arrays of numbers',
  cellValues: 'an object with a name and values as a Float64Array',
  noLayer: (word: string, names: readonly string[]) =>
    `There is no layer ${word}. The layers are ${listed(names, 'and')}.`,
  /** `reason` is the message of the failure, possibly in English. */
  notComputed: (reason: string) => `The diagram could not be computed: ${reason}.`,
  notDrawn: 'The picture could not be drawn.',
  /** Drawing failed, and a new thread continues. `reason` is the message of the failure, possibly in English. */
  drawingFailed: (reason: string) => `Drawing the picture failed and was started again: ${reason}.`,
  /** Drawing has failed repeatedly. */
  drawingEnded: (reason: string) => `The picture can no longer be drawn: ${reason}. Reload the page.`,
  nothingChanged: 'Nothing has changed. Try again.',
  areasWithoutRegion: 'Areas need a region: the cells divide it.',
  latticeWithRegion: 'A lattice takes no region: its cells are whole.',
  /** The number of areas differs from the number of circles. */
  areasForCircles: (areas: number, circles: number) => `There are ${areas} areas for ${circles} circles.`,
  tooManyForAreas: (most: number) => `Areas can be given to at most ${most} cells here.`,
  notRegion: (reason: string) => `This is neither GeoJSON nor well-known text of polygons: ${reason}`,
  disposed: 'it was disposed of',
  noThread: 'its file cannot be loaded',
}

export type Refusals = typeof ENGLISH_REFUSALS

/** An error with a message in any language. */
export interface LocalizedError<Words> extends Error {
  say(words: Words): string
}

/** A request that cannot be fulfilled. Its message is English; `say` localizes it. */
export class Refusal<Words = Refusals> extends CircleVoronoiError implements LocalizedError<Words> {
  readonly say: (words: Words) => string

  constructor(english: Words, say: (words: Words) => string, code: ErrorCode = 'badInput') {
    super(code, say(english))
    this.say = say
  }
}

/** A failure of the thread that does not depend on the request. */
export class Failure extends Error implements LocalizedError<Refusals> {
  readonly say: (words: Refusals) => string

  constructor(say: (words: Refusals) => string) {
    super(say(ENGLISH_REFUSALS))
    this.say = say
  }
}

/** Reports that an edit's circles have been replaced before it ran. The edit had no effect. */
export class Superseded extends Error {
  constructor() {
    super('These edits are for circles that are no longer there.')
  }
}

/** Formats a value for a sentence in any language. */
export function shownValue(value: unknown): string {
  const text = jsonOf(value) ?? typeof value
  return text.length > 40 ? `${text.slice(0, 40)}…` : text
}

/** JSON of any value. BigInts are written as numbers; an object without JSON gets the name of its type. */
function jsonOf(value: unknown): string | undefined {
  try {
    return JSON.stringify(value, (_, part) => (typeof part === 'bigint' ? `${part}n` : part))
  } catch {
    return Object.prototype.toString.call(value)
  }
}
