/** @jsxImportSource react */
// SPDX-License-Identifier: GPL-3.0-or-later
// Types of the element in React: `npm run check` compiles this.
import '../../../web/element/index.ts'
import { useRef, useState } from 'react'
import type { CircleVoronoiElement } from '../../../web/element/index.ts'

export function Figure() {
  const [circles, setCircles] = useState<Float64Array>()
  const figure = useRef<CircleVoronoiElement>(null)
  return (
    <>
      <circle-voronoi
        ref={figure}
        className="figure"
        circles={circles}
        layers={{ cells: 'degree' }}
        view="0 0 5"
        region={{ type: 'Polygon', coordinates: [] }}
        areas={[1, 2]}
        check={null}
        controls
        oncircleschange={({ detail }) => setCircles(detail.circles)}
      />
      {/* @ts-expect-error There is no such method. */}
      <circle-voronoi method="magic" />
      {/* @ts-expect-error Nor such a layer. */}
      <circle-voronoi layers={{ dsic: true }} />
      {/* @ts-expect-error An event has no such detail. */}
      <circle-voronoi onerror={({ detail }) => detail.circles} />
    </>
  )
}
