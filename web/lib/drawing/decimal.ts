// SPDX-License-Identifier: GPL-3.0-or-later
// Writes numbers rounded to some digits after the decimal point. The text is collected as bytes, because a string for
// each number would take most of the time of an SVG path.

/** The largest scaled number for which a quotient of doubles is not rounded to the wrong whole number. */
const MOST = 2 ** 44
/** The number of digits that fit into a 32-bit integer. */
const MOST_DIGITS = 8

const bytes = new Uint8Array(2 ** 14)
/** The largest number of bytes of one path command with its numbers. */
const MOST_COMMAND_BYTES = 256
const decoder = new TextDecoder()
/** The text that owns the buffer, and the number of bytes it uses. */
let writing: DecimalText | undefined
let used = 0

/** A text with numbers, which have at most `digits` digits after the decimal point and no trailing zeros. */
export class DecimalText {
  readonly #digits: number
  readonly #scale: number
  #text = ''

  /** `digits` is at least 0. If a double has fewer digits, all digits are written. */
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
    if (writing !== this || used > bytes.length - MOST_COMMAND_BYTES) this.#begin()
    for (let k = 0; k < text.length; k++) bytes[used++] = text.charCodeAt(k)
  }

  /** Adds a number. */
  addNumber(value: number): void {
    if (writing !== this || used > bytes.length - MOST_COMMAND_BYTES) this.#begin()
    const scale = this.#scale
    const scaled = Math.round(value * scale)
    const size = Math.abs(scaled)
    const quotient = size / scale
    if (!(size < MOST && quotient < 2 ** 31) || this.#digits > MOST_DIGITS) {
      // A double beyond 2^53 has no digits after the decimal point.
      this.add(`${size < 2 ** 53 ? scaled / scale : value}`)
      return
    }
    if (scaled < 0) bytes[used++] = MINUS
    const whole = quotient | 0
    let count = 1
    for (let power = 10; power <= whole; power *= 10) count += 1
    addDigits(whole, count)
    // 32-bit integers, because the remainder of doubles is slower.
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

/** Writes the last `count` digits of a whole number. */
function addDigits(value: number, count: number): void {
  let rest = value
  for (let k = used + count; k > used; ) {
    const tenth = (rest / 10) | 0
    bytes[--k] = ZERO + rest - 10 * tenth
    rest = tenth
  }
  used += count
}
