// SPDX-License-Identifier: GPL-3.0-or-later

/** Circles with a smaller radius are drawn as dots of this radius, in pixels. */
export const DOT_RADIUS = 1.5
/** Number of colors of the ramp for measures that a page can set. */
const TINTS = 6
/** Number of shades of the ramp, interpolated between those colors. */
export const SHADES = 61
/** Number of colors by which circles differ. */
export const MAP_COLORS = 8
/** Number of these colors that greedy coloring in smallest-last order needs for any map. */
export const ENOUGH_COLORS = 6

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

/** The colors of a drawing, as CSS colors. */
export type Style = { readonly [name in (typeof COLORS)[number]]: string } & {
  /** `SHADES` colors for measures, from the smallest to the largest. */
  readonly ramp: readonly string[]
  /** The colors that distinguish neighbors. */
  readonly map: readonly string[]
  /** Opacity of a cell's tint relative to its circle's color. */
  readonly cellOpacity: number
}

const NAMES = [...COLORS, 'cellOpacity', ...numbered('tint', TINTS), ...numbered('map', MAP_COLORS)]

/** The custom property of each color, without its prefix. */
export const STYLE_PROPERTIES: Readonly<Record<string, string>> = Object.fromEntries(
  NAMES.map((name) => [name, name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)]),
)

/**
 * Reads the style from an element's custom properties. A page may set `--circle-voronoi-edge`; the default for `edge`
 * comes from the theme.
 */
export function readStyle(element: Element): Style {
  const given = Object.entries(STYLE_PROPERTIES).map(([name, property]) => [
    name,
    `var(--circle-voronoi-${property}, var(--${property}))`,
  ])
  return styleOf(computedColors(element, Object.fromEntries(given)))
}

/** Builds a style from computed colors by name. */
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
 * Resolves CSS colors to numbers in the context of an element. Workers and canvases know neither custom properties nor
 * the color scheme nor system colors.
 */
export function computedColors<Name extends string>(
  element: Element,
  colors: Readonly<Record<Name, string>>,
): Record<Name, string> {
  const names = Object.keys(colors) as Name[]
  const probes = document.createElement('span')
  for (const name of names) {
    const { style } = probes.appendChild(document.createElement('span'))
    // Forced colors must not replace the colors of data; system colors are used by name where wanted.
    style.setProperty('forced-color-adjust', 'none')
    style.color = colors[name]
  }
  // Appends all probes at once, because each first read recomputes styles.
  element.append(probes)
  const computed = names.map((name, k) => [name, getComputedStyle(probes.children[k] as Element).color])
  probes.remove()
  return Object.fromEntries(computed) as Record<Name, string>
}

function numbered(name: string, count: number): string[] {
  return Array.from({ length: count }, (_, k) => `${name}-${k}`)
}

/** Interpolates a ramp of `SHADES` colors through some colors. */
export function rampThrough(stops: readonly string[]): string[] {
  const last = stops.length - 1
  return Array.from({ length: SHADES }, (_, k) => {
    const place = (k / (SHADES - 1)) * last
    const from = Math.min(Math.floor(place), last - 1)
    return mixed(stops[from] as string, stops[from + 1] as string, place - from)
  })
}

/** Falls back to the nearer color if a page's color is not in red, green and blue. */
function mixed(one: string, other: string, share: number): string {
  const [from, to] = [channelsOf(one), channelsOf(other)]
  if (from === undefined || to === undefined) return share < 0.5 ? one : other
  return `rgb(${from.map((value, k) => Math.round(value + share * ((to[k] as number) - value))).join(', ')})`
}

function channelsOf(color: string): readonly number[] | undefined {
  return /^rgb\((\d+), (\d+), (\d+)\)$/.exec(color)?.slice(1).map(Number)
}

/** Whether a computed color is visible. */
export function isSeen(color: string): boolean {
  return opacityOf(color) > 0
}

/** Whether the drawing is light on dark. */
export function isDark({ paper }: Style): boolean {
  const [red = 255, green = 255, blue = 255] = /^rgba?\((\d+), (\d+), (\d+)/.exec(paper)?.slice(1).map(Number) ?? []
  return red + green + blue < 1.5 * 255
}

/** The opacity of a computed CSS color; the default is 1. */
function opacityOf(color: string): number {
  return Number(/^rgba\(.*, ([\d.e-]+)\)$/.exec(color)?.[1] ?? 1)
}
