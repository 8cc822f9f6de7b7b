// SPDX-License-Identifier: GPL-3.0-or-later
// In place of ../../wasm/default-wasm.ts in the bundle: the bytes themselves, which stand in the file compressed, as base64.
import compressed from '../../generated/circle-voronoi.wasm'

/** Decoded when they are asked for, while they are compiled. */
export function defaultWasm(): Response {
  const bytes = Uint8Array.from(atob(compressed), (character) => character.charCodeAt(0))
  const wasm = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))
  return new Response(wasm, { headers: { 'Content-Type': 'application/wasm' } })
}
