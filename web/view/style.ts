// SPDX-License-Identifier: GPL-3.0-or-later

/** Smaller circles are drawn as dots of this radius, in pixels. */
export const DOT_RADIUS = 1.5
/** How many colors a page may set of the ramp by which measures are shown. */
export const TINTS = 6
/** How many shades the ramp has between them. */
export const SHADES = 61
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
  'region',
] as const

/** The colors of the drawing: CSS colors. */
export type Style = { readonly [name in (typeof COLORS)[number]]: string } & {
  /** `SHADES` colors for measures, from the smallest to the largest. */
  readonly ramp: readonly string[]
  /** For neighbors to differ. */
  readonly map: readonly string[]
  /** A cell has the tint of its circle, so much weaker. */
  readonly cellOpacity: number
}

const NAMES = [...COLORS, 'cellOpacity', ...numbered('tint', TINTS), ...numbered('map', MAP_COLORS)]

/** The custom property of each color of a style, without what stands before it. */
export const STYLE_PROPERTIES: Readonly<Record<string, string>> = Object.fromEntries(
  NAMES.map((name) => [name, name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)]),
)

/**
 * The style that the custom properties of an element say: for `edge` that of `--circle-voronoi-edge`, which a page may set,
 * or else that of the theme.
 */
export function readStyle(element: Element): Style {
  const given = Object.entries(STYLE_PROPERTIES).map(([name, property]) => [
    name,
    `var(--circle-voronoi-${property}, var(--${property}))`,
  ])
  return styleOf(computedColors(element, Object.fromEntries(given)))
}

/** The style of computed colors, by their names. */
export function styleOf(colors: Readonly<Record<string, string>>): Style {
  const color = (name: string) => colors[name] as string
  return {
    ...(Object.fromEntries(COLORS.map((name) => [name, color(name)])) as Record<(typeof COLORS)[number], string>),
    ramp: rampThrough(numbered('tint', TINTS).map(color)),
    map: numbered('map', MAP_COLORS).map(color),
    cellOpacity: opacityOf(color('cellOpacity')),
  }
}

/**
 * Colors of CSS as numbers, as they are inside an element: neither a worker nor a canvas knows custom properties, the scheme or
 * the system's colors.
 */
export function computedColors<Name extends string>(
  element: Element,
  colors: Readonly<Record<Name, string>>,
): Record<Name, string> {
  const names = Object.keys(colors) as Name[]
  const probes = document.createElement('span')
  for (const name of names) {
    const { style } = probes.appendChild(document.createElement('span'))
    // The system's colors are named where they are to be: data keeps its own.
    style.setProperty('forced-color-adjust', 'none')
    style.color = colors[name]
  }
  // All at once: the browser finds the styles anew when the first of them is read.
  element.append(probes)
  const computed = names.map((name, k) => [name, getComputedStyle(probes.children[k] as Element).color])
  probes.remove()
  return Object.fromEntries(computed) as Record<Name, string>
}

function numbered(name: string, count: number): string[] {
  return Array.from({ length: count }, (_, k) => `${name}-${k}`)
}

/** A ramp of `SHADES` colors that goes evenly through some colors. */
export function rampThrough(stops: readonly string[]): string[] {
  const last = stops.length - 1
  return Array.from({ length: SHADES }, (_, k) => {
    const place = (k / (SHADES - 1)) * last
    const from = Math.min(Math.floor(place), last - 1)
    return mixed(stops[from] as string, stops[from + 1] as string, place - from)
  })
}

/** Where a page has set a color that is not written as red, green and blue, the nearer one of two. */
function mixed(one: string, other: string, share: number): string {
  const [from, to] = [channelsOf(one), channelsOf(other)]
  if (from === undefined || to === undefined) return share < 0.5 ? one : other
  return `rgb(${from.map((value, k) => Math.round(value + share * ((to[k] as number) - value))).join(', ')})`
}

function channelsOf(color: string): readonly number[] | undefined {
  return /^rgb\((\d+), (\d+), (\d+)\)$/.exec(color)?.slice(1).map(Number)
}

/** Whether a computed color can be seen. */
export function isSeen(color: string): boolean {
  return opacityOf(color) > 0
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
