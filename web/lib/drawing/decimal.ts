// SPDX-License-Identifier: GPL-3.0-or-later
// Text of numbers that are rounded to some digits after the decimal point. It is written as bytes: a string for each number
// would take most of the time of an SVG path.

/** Beyond it a quotient of doubles may be rounded to a whole number that it is not. */
const MOST = 2 ** 44
/** The digits that an integer of 32 bits has room for. */
const MOST_DIGITS = 8

const bytes = new Uint8Array(2 ** 14)
/** Room for a command of a path with its numbers. */
const ROOM = 256
const decoder = new TextDecoder()
/** The text that is being written to the bytes, and how many of them it uses. */
let writing: DecimalText | undefined
let used = 0

/** A text, and numbers in it with at most `digits` digits after the decimal point, without zeros at the end. */
export class DecimalText {
  readonly #digits: number
  readonly #scale: number
  #text = ''

  /** `digits`: from 0. More than a double has stand for all of them. */
  constructor(digits: number) {
    this.#digits = digits
    this.#scale = 10 ** digits
  }

  /** Whether nothing has been written. */
  get isEmpty(): boolean {
    return this.#text === '' && writing !== this
  }

  toString(): string {
    if (writing === this) {
      this.#flush()
      writing = undefined
    }
    return this.#text
  }

  /** Returns the text and begins again with an empty one. */
  take(): string {
    const text = this.toString()
    this.#text = ''
    return text
  }

  /** Adds a few ASCII characters. */
  add(text: string): void {
    if (writing !== this || used > bytes.length - ROOM) this.#begin()
    for (let k = 0; k < text.length; k++) bytes[used++] = text.charCodeAt(k)
  }

  /** Adds a number. */
  addNumber(value: number): void {
    if (writing !== this || used > bytes.length - ROOM) this.#begin()
    const scale = this.#scale
    const scaled = Math.round(value * scale)
    const size = Math.abs(scaled)
    const quotient = size / scale
    if (!(size < MOST && quotient < 2 ** 31) || this.#digits > MOST_DIGITS) {
      // Beyond 2^53 a double has no digits to round off.
      this.add(`${size < 2 ** 53 ? scaled / scale : value}`)
      return
    }
    if (scaled < 0) bytes[used++] = MINUS
    const whole = quotient | 0
    let count = 1
    for (let power = 10; power <= whole; power *= 10) count += 1
    addDigits(whole, count)
    // An integer of 32 bits: the remainder of a double takes longer.
    let rest = (size - whole * scale) | 0
    if (rest === 0) return
    bytes[used++] = POINT
    count = this.#digits
    for (let tenth = (rest / 10) | 0; 10 * tenth === rest; tenth = (rest / 10) | 0) {
      rest = tenth
      count -= 1
    }
    addDigits(rest, count)
  }

  #begin(): void {
    if (writing !== undefined) writing.#flush()
    writing = this
  }

  #flush(): void {
    this.#text += decoder.decode(bytes.subarray(0, used))
    used = 0
  }
}

const [MINUS, POINT, ZERO] = [0x2d, 0x2e, 0x30]

/** The last `count` digits of a whole number. */
function addDigits(value: number, count: number): void {
  let rest = value
  for (let k = used + count; k > used; ) {
    const tenth = (rest / 10) | 0
    bytes[--k] = ZERO + rest - 10 * tenth
    rest = tenth
  }
  used += count
}
