// SPDX-License-Identifier: GPL-3.0-or-later
import type { CircleVoronoiElement } from '../element/index.ts'
import { encodeLink } from '../lib/link.ts'

/** The links of figures lead to what they show now, not to what they showed at first. */
export function linkFigures(page: ParentNode): void {
  for (const link of page.querySelectorAll<HTMLAnchorElement>('a.open')) {
    const figure = link.closest('figure')?.querySelector<CircleVoronoiElement>('circle-voronoi')
    // Others see to their own links.
    if (figure === null || figure === undefined) continue
    const [address] = link.href.split('#') as [string]
    const follow = async () => {
      const state = figure.getState()
      const played = state.step !== undefined && { method: figure.getAttribute('method') ?? undefined }
      link.href = `${address}#${await encodeLink({ ...state, ...played })}`
    }
    figure.addEventListener('circleschange', follow)
    // The picture may have been moved, or show other things.
    for (const name of ['pointerenter', 'focus']) link.addEventListener(name, follow)
  }
}
