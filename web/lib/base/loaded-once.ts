// SPDX-License-Identifier: GPL-3.0-or-later

/** Returns a function that calls `load` once, with its first arguments. After a failure, the next call tries again. */
export function loadedOnce<Args extends readonly unknown[], Loaded>(
  load: (...args: Args) => Promise<Loaded>,
): (...args: Args) => Promise<Loaded> {
  let loaded: Promise<Loaded> | undefined
  return (...args) => {
    loaded ??= load(...args).catch((error) => {
      loaded = undefined
      throw error
    })
    return loaded
  }
}
