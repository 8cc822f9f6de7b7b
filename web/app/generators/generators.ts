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

/** A family of random circles, with the data of the program's `generate --list`. */
export interface Family extends Figure {
  readonly isDisjoint: boolean
  /** Whether more than three circles touch a disc or share a tangent line. */
  readonly isDegenerate: boolean
}

/** A reproducible recipe: it gives the same circles on every machine. */
export type Recipe =
  | { readonly kind: 'family'; readonly family: string; readonly seed: number; readonly count: number }
  | { readonly kind: 'figure'; readonly figure: string }

/** A family or figure with sample circles for a thumbnail. */
export type Pictured<Kind extends Figure> = Kind & { readonly sample: Float64s }

/** All families and figures. */
export interface Catalogue {
  readonly families: readonly Pictured<Family>[]
  readonly figures: readonly Pictured<Figure>[]
}

const SAMPLE = 40
/** Number of circles above which a thumbnail gets a smaller sample. */
const LARGEST_SAMPLE = 300

export interface Generators {
  /** @throws CircleVoronoiError `badInput` if the family or figure is unknown */
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
