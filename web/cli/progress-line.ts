// SPDX-License-Identifier: GPL-3.0-or-later
// As cpp/cli/progress_line.cpp.
import { writeSync } from 'node:fs'

const PERIOD = 100
const STANDARD_ERROR = 2

/** A line on standard error that says what is being done and since when, rewritten in place and erased in the end. */
export class ProgressLine {
  #begin = 0
  #delay = Infinity
  #refresher: NodeJS.Timeout | undefined
  #stage = ''
  #done = 0
  #width = 0

  /** `delay`: milliseconds until it is first shown. */
  begin(delay: number): void {
    this.#begin = performance.now()
    this.#delay = delay
    this.#refresher = setInterval(() => this.#write(), PERIOD)
    this.#refresher.unref()
  }

  /** What is being done, and the part of it that is; 0 also where that is not known. */
  show(stage: string, done: number): void {
    const isNew = this.#stage !== stage
    this.#stage = stage
    this.#done = done
    if (isNew) this.#write()
  }

  /** Erases the line for good. */
  end(): void {
    clearInterval(this.#refresher)
    this.#delay = Infinity
    this.#replace('')
  }

  #write(): void {
    const elapsed = performance.now() - this.#begin
    if (this.#stage === '' || elapsed < this.#delay) return
    const part = this.#done > 0 ? ` ${Math.round(100 * this.#done)} %` : ''
    this.#replace(`${this.#stage}${part}, ${Math.floor(elapsed / 1000)} s`)
  }

  #replace(text: string): void {
    const blank = this.#width > 0 ? `\r${' '.repeat(this.#width)}\r` : ''
    if (blank + text !== '') writeSync(STANDARD_ERROR, blank + text)
    this.#width = text.length
  }
}
