// SPDX-License-Identifier: GPL-3.0-or-later
import { CircleVoronoiError } from '../../lib/base/errors.ts'
import type { Float64s } from '../../lib/index.ts'
import { compileWasm, instantiate, type WasmSource } from '../../lib/wasm/wasm.ts'
import createModule from '../generated/families.js'

/** A figure of the paper. */
export interface Figure {
  readonly name: string
  readonly description: string
}

/** A family of random circles, with what the program's `generate --list` says of it. */
export interface Family extends Figure {
  readonly isDisjoint: boolean
  /** Whether more than three circles touch one disc, or share a tangent line. */
  readonly isDegenerate: boolean
}

/** How circles are made: the same ones each time, on every machine. */
export type Recipe =
  | { readonly kind: 'family'; readonly family: string; readonly seed: number; readonly count: number }
  | { readonly kind: 'figure'; readonly figure: string }

/** A family or a figure, and some circles of it for a small picture. */
export type Pictured<Kind extends Figure> = Kind & { readonly sample: Float64s }

/** All that can be made. */
export interface Catalogue {
  readonly families: readonly Pictured<Family>[]
  readonly figures: readonly Pictured<Figure>[]
}

const SAMPLE = 40
/** More circles than this cannot be told from one another in a small picture. */
const LARGEST_SAMPLE = 300

export interface Generators {
  /** @throws CircleVoronoiError `badInput`, if there is no family or figure of this name */
  make(recipe: Recipe): Float64s
  catalogue(): Catalogue
}

/** @throws CircleVoronoiError `notLoaded` */
export async function loadGenerators(wasm?: WasmSource): Promise<Generators> {
  const beside = () => new URL('../generated/families.wasm', import.meta.url)
  const module = await instantiate(createModule, await compileWasm(wasm, beside))

  const make = (recipe: Recipe): Float64s => {
    const circles =
      recipe.kind === 'figure'
        ? module.figure(recipe.figure)
        : module.generate(recipe.family, recipe.count, recipe.seed)
    if (circles !== undefined) return circles
    const name = recipe.kind === 'figure' ? `figure "${recipe.figure}"` : `family "${recipe.family}"`
    throw new CircleVoronoiError('badInput', `There is no ${name}.`)
  }
  const sampleOf = (circles: Float64s) => (circles.length > 3 * LARGEST_SAMPLE ? circles.slice(0, 3 * SAMPLE) : circles)

  return {
    make,
    catalogue: () => ({
      families: module.families().map((family) => ({
        ...family,
        sample: make({ kind: 'family', family: family.name, seed: 1, count: SAMPLE }),
      })),
      figures: module
        .figures()
        .map((figure) => ({ ...figure, sample: sampleOf(make({ kind: 'figure', figure: figure.name })) })),
    }),
  }
}
