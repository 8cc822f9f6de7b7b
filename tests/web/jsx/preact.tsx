/** @jsxImportSource preact */
// SPDX-License-Identifier: GPL-3.0-or-later
// Types of the element in Preact: `npm run check` compiles this.
import '../../../web/element/index.ts'

export function Figure({ circles }: { circles: number[][] | undefined }) {
  return (
    <>
      <circle-voronoi class="figure" circles={circles} readonly onerror={({ detail }) => detail.error.message} />
      {/* @ts-expect-error There is no such method. */}
      <circle-voronoi method="magic" />
    </>
  )
}
