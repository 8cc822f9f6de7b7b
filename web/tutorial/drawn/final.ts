// SPDX-License-Identifier: GPL-3.0-or-later
// A tile of a larger plane, with the cells that stay the same whatever lies outside the tile. The slider sets the
// largest radius of the circles outside.
import { coordinatesOf, drawDiscs, type Kind, Pen } from './scene.ts'

const LARGEST = 3

export const finalCells: Kind = {
  range: () => ({ last: LARGEST, step: 'any' }),

  draw(scene, value, library) {
    const pen = new Pen(scene)
    // The tile is the visible part of the plane without a margin.
    const margin = pen.units(36)
    const [left, bottom, right, top] = pen.bounds
    const box = { minX: left + margin, minY: bottom + margin, maxX: right - margin, maxY: top - margin }
    const circles = scene.circles.filter(({ x, y }) => x > box.minX && x < box.maxX && y > box.minY && y < box.maxY)
    if (circles.length === 0) return { content: pen.content, told: 'No circle has its center in the tile.' }
    const diagram = library.compute(coordinatesOf(circles))
    const final = library.finalCells(diagram, { box, maxRadius: value })
    const options = { bounds: [...pen.bounds] as [number, number, number, number] }
    let count = 0
    for (let i = 0; i < circles.length; i++) {
      const isFinal = final.neededHalo[i] === 0
      if (isFinal) count += 1
      pen.path(isFinal ? 'cell c2 final' : 'cell open-cell', diagram.cellPath(i, options))
    }
    pen.path('edge', diagram.render(options))
    drawDiscs(
      pen,
      circles,
      circles.map((_, i) => (final.neededHalo[i] === 0 ? 2 : 6)),
      false,
    )
    const { minX, minY, maxX, maxY } = box
    pen.path('tile', `M${minX},${minY}H${maxX}V${maxY}H${minX}Z`)
    return {
      content: pen.content,
      told: `If no circle outside is larger than ${Number(value.toFixed(1))}, ${count} of ${circles.length} cells are final.`,
    }
  },
}
