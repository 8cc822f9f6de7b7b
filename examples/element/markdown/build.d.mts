// SPDX-License-Identifier: GPL-3.0-or-later
/** Writes the page. `module` is the address of circle-voronoi/element. */
export function buildSite(folder: string, module: string): void
