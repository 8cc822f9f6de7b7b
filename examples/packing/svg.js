// SPDX-License-Identifier: GPL-3.0-or-later
// Returns a packing as the text of an SVG, with cells, discs, and lines between touching discs. A cell is darker if its
// disc fills more of it.
import { touching } from './packing.js'

/** `width` is the width of the picture in pixels. */
export function svgOf(periodic, width) {
  const { diagram, circleCount, lattice } = periodic
  const { circles } = diagram
  const { packingFractions } = periodic.contacts()
  const { a, b } = lattice
  const corners = [[0, 0], a, [a[0] + b[0], a[1] + b[1]], b]
  const [xs, ys] = [0, 1].map((axis) => corners.map((corner) => corner[axis]))
  const margin = 0.08 * (Math.max(...xs) - Math.min(...xs))
  const [minX, minY] = [Math.min(...xs) - margin, Math.min(...ys) - margin]
  const size = [Math.max(...xs) + margin - minX, Math.max(...ys) + margin - minY]
  const indices = Array.from({ length: circleCount }, (_, i) => i)
  const cells = indices.map((i) => {
    const share = Math.min(Math.max((packingFractions[i] - 0.7) / 0.25, 0), 1)
    return `<path d="${periodic.cellPath(i)}" fill="hsl(${(212 - 30 * share).toFixed()} 55% ${(92 - 34 * share).toFixed()}%)"/>`
  })
  const discs = indices.map((i) => {
    const [x, y, r] = circles.subarray(3 * i, 3 * i + 3)
    return `<circle cx="${x}" cy="${y}" r="${r}"/>`
  })
  const lines = touching(periodic).map(([i, j, s, t]) => {
    const [x, y] = [s * a[0] + t * b[0], s * a[1] + t * b[1]]
    return `<path d="M${circles[3 * i]} ${circles[3 * i + 1]}L${circles[3 * j] + x} ${circles[3 * j + 1] + y}"/>`
  })
  const copies = [-1, 0, 1].flatMap((s) =>
    [-1, 0, 1].map((t) => `<use href="#packing" x="${s * a[0] + t * b[0]}" y="${s * a[1] + t * b[1]}"/>`),
  )
  const box = `M${corners.map((corner) => corner.join(' ')).join('L')}Z`
  const line = (pixels) => ((pixels * size[0]) / width).toFixed(5)
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="${minX} ${-minY - size[1]} ${size.join(' ')}" width="${width}" height="${Math.round((width * size[1]) / size[0])}">
<defs>
<clipPath id="box"><path d="${box}"/></clipPath>
<g id="packing">
<g stroke="#fff" stroke-width="${line(1.2)}">
${cells.join('\n')}
</g>
<g fill="#1f4e79" fill-opacity="0.55">
${discs.join('\n')}
</g>
<g stroke="#d9822b" stroke-width="${line(2)}" stroke-linecap="round">
${lines.join('\n')}
</g>
</g>
<g id="copies">
${copies.join('\n')}
</g>
</defs>
<rect x="${minX}" y="${-minY - size[1]}" width="${size[0]}" height="${size[1]}" fill="#fff"/>
<g transform="scale(1 -1)">
<g opacity="0.3"><use href="#copies"/></g>
<g clip-path="url(#box)"><use href="#copies"/></g>
<path d="${box}" fill="none" stroke="#2a3140" stroke-width="${line(1.5)}"/>
</g>
</svg>
`
}
