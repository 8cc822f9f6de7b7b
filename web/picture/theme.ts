// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluates the style sheets without a browser, as `getComputedStyle` would, in a light or a dark scheme.
import playerSheet from '../player/player.css?inline'
import { type Colors, PLAYER_COLORS } from '../player/step-overlay.ts'
import { STYLE_PROPERTIES, type Style, styleOf } from '../view/style.ts'
import themeSheet from '../view/theme.css?inline'
import type { Scheme } from './scheme.ts'

/** The colors of the drawing. */
export function themeStyle(scheme: Scheme): Style {
  const read = colorReader(themeSheet, '.circle-voronoi', scheme)
  return styleOf(mapped(STYLE_PROPERTIES, (property) => read(`var(--${property})`)))
}

/** The colors of the player's overlay. */
export function playerColors(scheme: Scheme): Colors {
  return mapped(PLAYER_COLORS, colorReader(playerSheet, '.cv-player', scheme))
}

function mapped<Names extends object>(names: Names, change: (value: string) => string): Record<keyof Names, string> {
  return Object.fromEntries(Object.entries(names).map(([name, value]) => [name, change(value)])) as never
}

/** Computes values with the custom properties of the first rule of a selector. */
function colorReader(sheet: string, selector: string, scheme: Scheme): (value: string) => string {
  const text = sheet.replace(/\/\*[\s\S]*?\*\//g, '')
  const rule = text.slice(text.indexOf('{', text.indexOf(selector)) + 1)
  const declarations = rule.slice(0, rule.indexOf('}')).matchAll(/(--[\w-]+)\s*:\s*([^;]+)/g)
  const properties = new Map(Array.from(declarations, ([, name, value]) => [name as string, (value as string).trim()]))

  const computed = (value: string): string => {
    const [, call, inner = ''] = /^(var|light-dark)\((.*)\)$/s.exec(value) ?? []
    const [first = '', second = ''] = argumentsIn(inner)
    if (call === 'light-dark') return computed(scheme === 'light' ? first : second)
    if (call === 'var') return computed(properties.get(first) ?? second)
    return serialized(value)
  }
  return computed
}

/** Splits the two arguments of a call. Arguments may contain calls. */
function argumentsIn(text: string): string[] {
  let depth = 0
  for (let k = 0; k < text.length; k++) {
    if (text[k] === '(') depth += 1
    if (text[k] === ')') depth -= 1
    if (text[k] === ',' && depth === 0) return [text.slice(0, k).trim(), text.slice(k + 1).trim()]
  }
  return [text.trim()]
}

/** Returns a color in the notation of browsers. */
function serialized(color: string): string {
  const [red, green, blue, alpha] = channelsOf(color)
  const rgb = `${red}, ${green}, ${blue}`
  return alpha === 1 ? `rgb(${rgb})` : `rgba(${rgb}, ${alpha})`
}

function channelsOf(color: string): [red: number, green: number, blue: number, alpha: number] {
  if (color === 'transparent') return [0, 0, 0, 0]
  const digits = /^#([\da-f]+)$/i.exec(color)?.[1]
  if (digits !== undefined) {
    const long = digits.length > 4 ? digits : [...digits].map((digit) => digit + digit).join('')
    const [red, green, blue, alpha = 255] = (long.match(/../g) as string[]).map((pair) => Number.parseInt(pair, 16))
    return [red as number, green as number, blue as number, alphaOf(alpha)]
  }
  const [, red, green, blue, alpha = '1', percent] =
    /^rgba?\((\d+)[ ,]+(\d+)[ ,]+(\d+)(?:[ ,/]+([\d.]+)(%)?)?\)$/.exec(color) ?? []
  if (red === undefined) throw new Error(`The style sheet has a color that cannot be read: ${color}`)
  return [Number(red), Number(green), Number(blue), Number(alpha) / (percent === undefined ? 1 : 100)]
}

/** Uses the fewest digits that give the same byte (CSS Color 4, section 15.2). */
function alphaOf(byte: number): number {
  const short = Math.round((100 * byte) / 255) / 100
  return Math.round(255 * short) === byte ? short : Math.round((1000 * byte) / 255) / 1000
}
