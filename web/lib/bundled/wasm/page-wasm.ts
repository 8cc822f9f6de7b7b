// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces ../../wasm/default-wasm.ts in the element's one-file build. The page compiles the core, and its thread contains
// the other modules (thread-wasm.ts). So the file works alone and from a disk, where nothing can be fetched.
import core from '../../generated/circle-voronoi.wasm'
import { unpacked } from './unpacked.ts'

export function defaultWasm(): Response {
  return unpacked(core)
}
