// SPDX-License-Identifier: GPL-3.0-or-later

/** Loads what `load` loads once, with the first arguments. What fails is tried again when it is asked for again. */
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
