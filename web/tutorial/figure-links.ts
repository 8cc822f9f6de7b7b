// SPDX-License-Identifier: GPL-3.0-or-later
import type { CircleVoronoiElement } from '../element/index.ts'
import { encodeLink } from '../lib/link.ts'

/** Keeps the links of figures up to date, so that they open the figure as the reader left it. */
export function linkFigures(page: ParentNode): void {
  for (const link of page.querySelectorAll<HTMLAnchorElement>('a.open')) {
    const figure = link.closest('figure')?.querySelector<CircleVoronoiElement>('circle-voronoi')
    // Other elements update their own links.
    if (figure === null || figure === undefined) continue
    const [address] = link.href.split('#') as [string]
    const follow = async () => {
      const state = figure.getState()
      const played = state.step !== undefined && { method: figure.getAttribute('method') ?? undefined }
      link.href = `${address}#${await encodeLink({ ...state, ...played })}`
    }
    figure.addEventListener('circleschange', follow)
    // The figure may have changed since the last time; readers need the link when they point at it.
    for (const name of ['pointerenter', 'focus']) link.addEventListener(name, follow)
  }
}
