// SPDX-License-Identifier: GPL-3.0-or-later
// In place of ../../threads/regions-script.ts in the bundle, which would be larger by what few programs need.
export { loadRegionsScript } from '../wasm/scripts-beside.ts'
