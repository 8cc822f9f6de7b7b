// SPDX-License-Identifier: GPL-3.0-or-later
// The types of the exports of cpp/wasm/printed_bindings.cpp.

interface PrintedModule {
  printed(
    circles: Float64Array,
    asPrinted: readonly import('./printed-rules.ts').Rule[],
  ): import('./printed-rules.ts').Printed | import('../lib/wasm/wasm.ts').WasmError
}

declare module '*/generated/printed.js' {
  export default function createModule(options: import('../lib/wasm/wasm.ts').EmscriptenOptions): Promise<PrintedModule>
}
