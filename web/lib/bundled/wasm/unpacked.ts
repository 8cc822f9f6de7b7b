// SPDX-License-Identifier: GPL-3.0-or-later

/** Returns the WebAssembly that a bundle contains as base64 of gzip. It is decoded while it is compiled. */
export function unpacked(compressed: string): Response {
  const bytes = Uint8Array.from(atob(compressed), (character) => character.charCodeAt(0))
  const wasm = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))
  return new Response(wasm, { headers: { 'Content-Type': 'application/wasm' } })
}
