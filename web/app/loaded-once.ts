// SPDX-License-Identifier: GPL-3.0-or-later

/** What is said of a part that did not come. */
export const NOT_LOADED = 'This part of the page could not be loaded. Try again.'

/** Loads what it loads once; what fails is tried again when it is asked for again. */
export function loadedOnce<Loaded>(load: () => Promise<Loaded>): () => Promise<Loaded> {
  let loaded: Promise<Loaded> | undefined
  return () => {
    loaded ??= load().catch((error) => {
      loaded = undefined
      throw error
    })
    return loaded
  }
}
