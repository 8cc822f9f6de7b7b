// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in attributes that are more than a word.
import type { LayerValue, LinkView } from '../lib/link.ts'
import { CELL_COLORS, DEFAULT_LAYERS, type Layers, layersFrom } from '../view/layers.ts'

/**
 * The layers that a text says: words, `hull` for a layer that is drawn, `no-edges` for one that is not, `cells=degree` and
 * `max-distance=2` for others; or an object in JSON.
 *
 * @throws Error that names the word which is none
 */
export function parseLayers(text: string): Layers {
  if (text.trim().startsWith('{')) {
    try {
      return layersFrom(JSON.parse(text))
    } catch (error) {
      throw new Error(`The layers are no JSON: ${(error as Error).message}.`)
    }
  }
  const kept: Record<string, LayerValue> = {}
  for (const word of text.split(/[\s,]+/).filter((word) => word !== '')) {
    const [name, value] = word.split('=') as [string, string | undefined]
    const isOff = name.startsWith('no-')
    const layer = camelCase(isOff ? name.slice(3) : name)
    const known = Object.hasOwn(DEFAULT_LAYERS, layer) ? DEFAULT_LAYERS[layer as keyof Layers] : undefined
    const isNumber = layer === 'maxDistance' || layer === 'nearZero'
    if (typeof known === 'boolean' && value === undefined) kept[layer] = !isOff
    else if (layer === 'cells' && isOff) kept.cells = 'none'
    else if (layer === 'cells' && (CELL_COLORS as readonly (string | undefined)[]).includes(value)) {
      kept.cells = value as string
    } else if (isNumber && value !== undefined && Number.isFinite(Number(value))) kept[layer] = Number(value)
    else throw new Error(`There is no layer ${word}.`)
  }
  return layersFrom(kept)
}

/**
 * The view that a text says: x and y of its middle, and how many units are seen at least in both directions.
 *
 * @throws Error
 */
export function parseView(text: string): LinkView {
  const [x, y, span, ...more] = text
    .trim()
    .split(/[\s,]+/)
    .map(Number) as [number, number, number]
  if (![x, y, span].every(Number.isFinite) || !(span > 0) || more.length > 0) {
    throw new Error('A view is three numbers: x, y and a span above 0.')
  }
  return { x, y, span }
}

/**
 * The step that a text says.
 *
 * @throws Error
 */
export function parseStep(text: string): number {
  const step = text.trim() === '' ? Number.NaN : Number(text)
  if (!(Number.isSafeInteger(step) && step >= 0)) throw new Error(`A step is a whole number from 0, not ${text}.`)
  return step
}

/** What of controls there is; `null`: none. Without words there are buttons. */
export function parseControls(text: string | null): { readonly hasButtons: boolean; readonly hasPlayer: boolean } {
  const words = (text ?? '').split(/\s+/).filter((word) => word !== '')
  const hasPlayer = words.includes('player')
  return { hasButtons: text !== null && (!hasPlayer || words.length > 1), hasPlayer }
}

function camelCase(name: string): string {
  return name.replace(/-([a-z])/g, (_, letter: string) => letter.toUpperCase())
}
