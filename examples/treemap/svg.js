// SPDX-License-Identifier: GPL-3.0-or-later
// Returns a treemap as the text of an SVG. Groups have colors, and names grow with their cells.

const COLORS = ['#e9b44c', '#6aa5c9', '#d9869f', '#86b98b', '#b9c4cf', '#a99bd0', '#e39a6f']
/** The size of names, relative to the square root of a cell's area. A name of average length fits. */
const SIZE_OF_NAMES = 1.3

/** `size` is the width and height of the picture. */
export function svgOf(cells, size) {
  const colors = new Map()
  const colorOf = (group) => {
    if (!colors.has(group)) colors.set(group, COLORS[colors.size % COLORS.length])
    return colors.get(group)
  }
  const leaves = cells.filter(({ isGroup }) => !isGroup)
  const largest = Math.max(...leaves.map(({ value }) => value))
  const shapes = leaves.map(({ names, value, path }) => {
    const strength = (0.45 + 0.4 * Math.sqrt(value / largest)).toFixed(2)
    const title = `<title>${escaped(names.join(', '))}: ${value}</title>`
    return `<path d="${path}" fill="${colorOf(names[0])}" fill-opacity="${strength}" data-names="${escaped(names.join('/'))}">${title}</path>`
  })
  const borders = cells.filter(({ isGroup }) => isGroup).map(({ path }) => path)
  const texts = leaves.map(({ name, area, center: { x, y } }) => {
    const longest = Math.max(...name.split(' ').map(({ length }) => length), 3)
    const height = Math.min((SIZE_OF_NAMES * Math.sqrt(area)) / longest, size / 30)
    const lines = name.split(' ')
    const spans = lines.map((word, k) => {
      const dy = (k - (lines.length - 1) / 2) * height * 1.1
      return `<tspan x="${x.toFixed(1)}" y="${(y + dy + height * 0.35).toFixed(1)}">${escaped(word)}</tspan>`
    })
    return `<text font-size="${height.toFixed(1)}">${spans.join('')}</text>`
  })
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${size} ${size}" width="${size}" height="${size}">
<g stroke="#fff" stroke-width="1.5">
${shapes.join('\n')}
</g>
<path d="${borders.join('')}" fill="none" stroke="#2a3140" stroke-width="2.5" stroke-linejoin="round"/>
<g font-family="sans-serif" text-anchor="middle" fill="#1d2430" pointer-events="none">
${texts.join('\n')}
</g>
</svg>
`
}

function escaped(text) {
  return text.replace(/[&<>"]/g, (character) => `&#${character.charCodeAt(0)};`)
}
