// SPDX-License-Identifier: GPL-3.0-or-later
import type { Point } from '../../web/lib/index.ts'
import type { Hands } from '../e2e/monkey.ts'

/** A key, or a combination of held keys: `a`, `Delete`, `Control+Shift+z`. */
export type Keys = string

/** A browser that a test drives, with one page in it. */
export interface Engine {
  /** The folder of downloads. */
  readonly downloads: string
  /** Single inputs, for the monkey. */
  readonly hands: Hands
  open(url: string): Promise<void>
  /** Calls a function in the page, which sees only its arguments, and waits for its result. Both are plain data. */
  evaluate<Args extends readonly unknown[], Result>(
    call: (...args: Args) => Result,
    ...args: Args
  ): Promise<Awaited<Result>>
  /** Presses the mouse at the first point, moves it to the others and releases it. A single point is a click. */
  drag(points: readonly Point[]): Promise<void>
  /**
   * Clicks the element that `find` returns in the page, and returns whether there is one. `find` sees only its
   * arguments.
   */
  click<Args extends readonly unknown[]>(
    find: (...args: Args) => HTMLElement | undefined,
    ...args: Args
  ): Promise<boolean>
  press(keys: Keys): Promise<void>
  /** Chooses a file of the disk in an `<input type="file">`. */
  choose(selector: string, path: string): Promise<void>
  close(): Promise<void>
}

/** The pixel of the window nearest to a point. The protocols refuse points outside. */
export function inWindow([x, y]: readonly [x: number, y: number]): [x: number, y: number] {
  return [Math.min(Math.max(Math.round(x), 0), innerWidth - 1), Math.min(Math.max(Math.round(y), 0), innerHeight - 1)]
}

/** The keys of a combination, in the order in which they are pressed. The key `+` is one, too. */
export const keysOf = (keys: Keys): string[] => keys.split(/(?<=.)\+/).map((key) => (key === 'Space' ? ' ' : key))

/** Interval between attempts, in milliseconds. */
const PAUSE = 50
/** Time limit in milliseconds, below the limit of a test, so that the error names the missing condition. */
const PATIENCE = 100_000

/** Waits until a value of the page is right, and returns it. */
export async function until<Said>(what: string, say: () => Promise<Said>, isRight: (said: Said) => boolean) {
  const start = performance.now()
  for (;;) {
    const said = await say()
    if (isRight(said)) return said
    if (performance.now() - start > PATIENCE) throw new Error(`Still not ${what}: ${JSON.stringify(said)}`)
    await new Promise((resolve) => setTimeout(resolve, PAUSE))
  }
}
