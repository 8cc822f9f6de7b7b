// SPDX-License-Identifier: GPL-3.0-or-later
// Corresponds to cpp/cli/progress_text.h and progress_line.cpp.
import { writeSync } from 'node:fs'

const PERIOD = 100
const STANDARD_ERROR = 2

/** A line on standard error with the current stage and the elapsed time, rewritten in place and erased at the end. */
export class ProgressLine {
  readonly #write: (text: string) => void
  #begin = 0
  #delay = Infinity
  #refresher: NodeJS.Timeout | undefined
  #stage = ''
  #percent: number | undefined
  #line = ''

  /** `write` writes to the terminal. Tests replace it. */
  constructor(write = (text: string): unknown => writeSync(STANDARD_ERROR, text)) {
    this.#write = write
  }

  /** Starts the line; it appears after `delay` milliseconds. */
  begin(delay: number): void {
    this.#begin = performance.now()
    this.#delay = delay
    this.#refresher = setInterval(() => this.#refresh(), PERIOD)
    this.#refresher.unref()
  }

  /** Sets the stage and the percentage done, if known. */
  show(stage: string, percent: number | undefined): void {
    if (stage === this.#stage && percent === this.#percent) return
    this.#stage = stage
    this.#percent = percent
    this.#refresh()
  }

  /** Erases the line for good. */
  end(): void {
    clearInterval(this.#refresher)
    this.#delay = Infinity
    this.#replace('')
  }

  #refresh(): void {
    const elapsed = performance.now() - this.#begin
    if (this.#stage === '' || elapsed < this.#delay) return
    const part = this.#percent === undefined ? '' : ` ${this.#percent} %`
    this.#replace(`${this.#stage}${part}, ${Math.floor(elapsed / 1000)} s`)
  }

  #replace(line: string): void {
    if (line === this.#line) return
    const blank = this.#line === '' ? '' : `\r${' '.repeat(this.#line.length)}\r`
    this.#line = line
    this.#write(blank + line)
  }
}
