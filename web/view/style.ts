// SPDX-License-Identifier: GPL-3.0-or-later

export const DISC_OPACITY = 0.85
/** Smaller circles are drawn as dots of this radius, in pixels. */
export const DOT_RADIUS = 1.5
/** How many tints circles and cells have by size. */
export const TINTS = 6
/** Every map takes at most so many colors that are chosen greedily, the cells with fewest neighbors last. */
export const MAP_COLORS = 6

const COLORS = [
  'paper',
  'edge',
  'rim',
  'hidden',
  'accent',
  'selectedDisc',
  'selectedCell',
  'neighborCell',
  'hull',
  'dual',
  'delaunay',
  'ordinary',
  'power',
  'touching',
  'path',
  'merged',
  'samples',
  'sampleGraph',
  'antipodalDiscs',
  'directedEdges',
  'missedEdges',
] as const

/** The colors of the drawing: CSS colors. */
export type Style = { readonly [name in (typeof COLORS)[number]]: string } & {
  /** From the smallest to the largest. */
  readonly tints: readonly string[]
  /** For neighbors to differ. */
  readonly map: readonly string[]
  /** A cell has the tint of its circle, so much weaker. */
  readonly cellOpacity: number
}

/**
 * The style that the custom properties of an element say: for `edge` that of `--circle-voronoi-edge`, which a page may set,
 * or else that of the theme.
 */
export function readStyle(element: Element): Style {
  const names = [...COLORS, 'cellOpacity', ...numbered('tint', TINTS), ...numbered('map', MAP_COLORS)]
  const probes = document.createElement('span')
  for (const name of names) {
    const property = name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)
    const { style } = probes.appendChild(document.createElement('span'))
    // The system's colors are named where they are to be: data keeps its own.
    style.setProperty('forced-color-adjust', 'none')
    style.color = `var(--circle-voronoi-${property}, var(--${property}))`
  }
  // All at once: the browser finds the styles anew when the first of them is read.
  element.append(probes)
  // As numbers: a worker knows neither the scheme nor the system's colors.
  const colors = Object.fromEntries(
    names.map((name, k) => [name, getComputedStyle(probes.children[k] as Element).color]),
  )
  probes.remove()
  const color = (name: string) => colors[name] as string
  return {
    ...(Object.fromEntries(COLORS.map((name) => [name, color(name)])) as Record<(typeof COLORS)[number], string>),
    tints: numbered('tint', TINTS).map(color),
    map: numbered('map', MAP_COLORS).map(color),
    cellOpacity: opacityOf(color('cellOpacity')),
  }
}

function numbered(name: string, count: number): string[] {
  return Array.from({ length: count }, (_, k) => `${name}-${k}`)
}

/** Whether what is drawn is light on dark. */
export function isDark({ paper }: Style): boolean {
  const [red = 255, green = 255, blue = 255] = /^rgba?\((\d+), (\d+), (\d+)/.exec(paper)?.slice(1).map(Number) ?? []
  return red + green + blue < 1.5 * 255
}

/** Of a computed color, which says it only if it is not 1. */
function opacityOf(color: string): number {
  return Number(/^rgba\(.*, ([\d.e-]+)\)$/.exec(color)?.[1] ?? 1)
}
