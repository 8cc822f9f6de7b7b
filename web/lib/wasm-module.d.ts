// SPDX-License-Identifier: GPL-3.0-or-later
// The types of what cpp/wasm/bindings.cpp and comparison_bindings.cpp export.

type WasmError = import('./wasm.ts').WasmError

interface WasmOptions {
  readonly weights: boolean | undefined
  readonly method: string | undefined
  readonly candidates: string | undefined
  readonly samples: number | undefined
  readonly resample: boolean | undefined
  /** Whether to go on; must not throw. */
  readonly progress: ((...told: Parameters<import('./options.ts').Progress>) => boolean) | undefined
}

type WasmDiagram = Omit<import('./diagram-data.ts').DiagramData, 'metric' | 'circles'>

type JudgedArrays = Omit<import('./diagram-data.ts').DiagramData, 'metric' | 'certificate' | 'stats'>

interface WasmModule {
  compute(circles: Float64Array, options: WasmOptions): WasmError | WasmDiagram
  certify(diagram: JudgedArrays): WasmError | import('./diagram-data.ts').Certificate
  /** `box`: minX, minY, maxX, maxY. */
  finalCells(diagram: JudgedArrays, box: Float64Array, maxRadius: number): WasmError | import('./library.ts').FinalCells
  errorCodeNames(): string[]
}

interface WasmComparisonModule {
  powerDiagram(circles: Float64Array): WasmError | WasmDiagram
}

declare module '*/generated/circle-voronoi.js' {
  export default function createModule(options: import('./wasm.ts').EmscriptenOptions): Promise<WasmModule>
}

declare module '*/generated/circle-voronoi-comparison.js' {
  export default function createModule(options: import('./wasm.ts').EmscriptenOptions): Promise<WasmComparisonModule>
}

/** In the bundle alone: gzip as base64. */
declare module '*/generated/circle-voronoi.wasm' {
  const compressed: string
  export default compressed
}
