// SPDX-License-Identifier: GPL-3.0-or-later
import { defaultRegionsWasm } from './default-wasm.ts'
import type { LoadOptions } from './load-options.ts'
import { loadRegionsScript } from './module-scripts.ts'
import { type Regions, regionsOf } from './regions.ts'
import { compileWasm, scriptNotLoaded } from './wasm.ts'

/**
 * Loads regions and fits.
 *
 * @throws CircleVoronoiError `notLoaded`
 */
export async function loadRegions({ wasm }: LoadOptions): Promise<Regions> {
  const { default: createModule } = await loadRegionsScript().catch(scriptNotLoaded('The regions'))
  const { region, fitAreas } = await regionsOf(createModule, await compileWasm(wasm, defaultRegionsWasm))
  return { region, fitAreas }
}
