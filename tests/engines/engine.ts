// SPDX-License-Identifier: GPL-3.0-or-later
import type { Point } from '../../web/lib/index.ts'

/** A key, or some that are held while the last one is pressed: `a`, `Delete`, `Control+Shift+z`. */
export type Keys = string

/** A browser that a test drives, with one page in it. */
export interface Engine {
  /** The folder where what is saved goes. */
  readonly downloads: string
  open(url: string): Promise<void>
  /** Has the page call a function, which sees nothing but its arguments; what it returns is waited for. Both are plain data. */
  evaluate<Args extends readonly unknown[], Result>(
    call: (...args: Args) => Result,
    ...args: Args
  ): Promise<Awaited<Result>>
  /** Presses the mouse at the first point, moves it to the others and releases it: with one point it clicks. */
  drag(points: readonly Point[]): Promise<void>
  /** Clicks the element that `find` returns in the page, and returns whether there is one. `find` sees only its arguments. */
  click<Args extends readonly unknown[]>(
    find: (...args: Args) => HTMLElement | undefined,
    ...args: Args
  ): Promise<boolean>
  press(keys: Keys): Promise<void>
  /** Chooses a file of the disk in an `<input type="file">`. */
  choose(selector: string, path: string): Promise<void>
  close(): Promise<void>
}

/** An attempt is made so often, in milliseconds. */
const PAUSE = 50
/** In milliseconds, less than the time limit of a test: the error then says what is missing. */
const PATIENCE = 100_000

/** Waits until something that the page says is as it should be, and returns it. */
export async function until<Said>(what: string, say: () => Promise<Said>, isRight: (said: Said) => boolean) {
  const start = performance.now()
  for (;;) {
    const said = await say()
    if (isRight(said)) return said
    if (performance.now() - start > PATIENCE) throw new Error(`Still not ${what}: ${JSON.stringify(said)}`)
    await new Promise((resolve) => setTimeout(resolve, PAUSE))
  }
}
