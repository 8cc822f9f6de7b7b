// SPDX-License-Identifier: GPL-3.0-or-later
// Hands a table over to the example `globe`, which opens in a new tab and asks for it.

/** The kind of both messages (examples/globe/brought.js). */
const ASK = 'circle-voronoi-globe'

/** A table with longitude, latitude and radius in its columns x, y and r. */
export interface GlobeTable {
  readonly name: string
  readonly text: string
  readonly unit: 'km' | 'm'
}

/** Opens the globe. Call this during a click, or browsers block the tab. Returns whether it has opened. */
export function openGlobe(table: Promise<GlobeTable>): boolean {
  const tab = window.open(new URL('examples/globe/', document.baseURI), '_blank')
  if (tab === null) return false
  // The tab asks again when it is reloaded.
  window.addEventListener('message', async ({ source, origin, data }) => {
    if (source !== tab || origin !== location.origin || data?.kind !== ASK) return
    tab.postMessage({ kind: ASK, ...(await table) }, location.origin)
  })
  return true
}
