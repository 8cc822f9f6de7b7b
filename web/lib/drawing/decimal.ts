// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers rounded to some digits after the decimal point, as text: several times as fast as to round and let the language
// find the shortest text, which takes most of the time of an SVG path.

const GROUP = 4
const SIZE = 10 ** GROUP
const MOST_GROUPS = 2
/** Below it no quotient that is taken apart here is rounded to a whole number that it is not. */
const MOST = 2 ** 44

/** The digits of numbers below 10^4, with zeros in front, but not those at the end if they come last; the first after a point. */
const FIRST_GROUPS: string[] = []
const LAST_GROUPS: string[] = []
const ONLY_GROUPS: string[] = []

/** Texts of numbers with at most `digits` of them after the decimal point, without zeros at the end. */
export class DecimalText {
  readonly #scale: number
  readonly #groups: number
  readonly #padding: number

  /** `digits`: from 0. More than a double has stand for all of them. */
  constructor(digits: number) {
    this.#scale = 10 ** digits
    this.#groups = Math.ceil(digits / GROUP)
    this.#padding = 10 ** (this.#groups * GROUP - digits)
    if (this.#groups > MOST_GROUPS || FIRST_GROUPS.length > 0) return
    for (let i = 0; i < SIZE; i++) {
      const text = String(i).padStart(GROUP, '0')
      const last = text.replace(/0+$/, '')
      FIRST_GROUPS.push(`.${text}`)
      LAST_GROUPS.push(last)
      ONLY_GROUPS.push(`.${last}`)
    }
  }

  /** The text of a number. */
  of(value: number): string {
    const scaled = Math.round(value * this.#scale)
    const size = Math.abs(scaled)
    // Beyond 2^53 a double has no digits to round off.
    if (!(size < MOST) || this.#groups > MOST_GROUPS) return `${size < 2 ** 53 ? scaled / this.#scale : value}`
    const whole = Math.trunc(size / this.#scale)
    const rest = (size - whole * this.#scale) * this.#padding
    // As few parts as may be: each makes a string of its own.
    const integer = scaled >= 0 ? `${whole}` : whole === 0 ? '-0' : `${-whole}`
    if (rest === 0) return integer
    if (this.#groups === 1) return integer + ONLY_GROUPS[rest]
    const first = Math.trunc(rest / SIZE)
    const last = rest - first * SIZE
    return last === 0 ? integer + ONLY_GROUPS[first] : integer + FIRST_GROUPS[first] + LAST_GROUPS[last]
  }
}
