// SPDX-License-Identifier: GPL-3.0-or-later
// The types of the exports of cpp/wasm/families_bindings.cpp.

interface FamiliesModule {
  families(): readonly import('./generators.ts').Family[]
  figures(): readonly import('./generators.ts').Figure[]
  /** Returns `undefined` if the family is unknown. */
  generate(name: string, count: number, seed: number): Float64Array<ArrayBuffer> | undefined
  figure(name: string): Float64Array<ArrayBuffer> | undefined
}

declare module '*/generated/families.js' {
  export default function createModule(
    options: import('../../lib/wasm/wasm.ts').EmscriptenOptions,
  ): Promise<FamiliesModule>
}
