// SPDX-License-Identifier: GPL-3.0-or-later
// Returns a treemap of two levels as the text of an SVG. Groups have colors, and names grow with their cells.

const COLORS = ['#e9b44c', '#6aa5c9', '#d9869f', '#86b98b', '#a99bd0', '#b9c4cf', '#e39a6f']
/** The size of names, relative to the square root of a cell's area. A name of average length fits. */
const SIZE_OF_NAMES = 1.05

/** `root` is what `treemap` returns; `size` is the width and height of the picture. */
export function svgOf(root, size) {
  const leaves = root.children.flatMap((group, k) => group.children.map((node) => ({ node, group, k })))
  const largest = Math.max(...leaves.map(({ node }) => node.value))
  const shapes = leaves.map(({ node, group, k }) => {
    const strength = (0.45 + 0.4 * Math.sqrt(node.value / largest)).toFixed(2)
    const title = `<title>${escaped(`${node.name}, ${group.name}`)}: ${Math.round(node.value)}</title>`
    return `<path d="${pathOf(node)}" fill="${COLORS[k % COLORS.length]}" fill-opacity="${strength}" data-names="${escaped(`${group.name}/${node.name}`)}">${title}</path>`
  })
  const texts = leaves.map(({ node: { name, area, polygon } }) => {
    const words = name.split(' ')
    const longest = Math.max(...words.map(({ length }) => length), 3)
    const height = Math.min((SIZE_OF_NAMES * Math.sqrt(area)) / longest, size / 30)
    const { x, y } = centroidOf(polygon)
    const lines = words.map((word, k) => {
      const dy = (k - (words.length - 1) / 2) * height * 1.1
      return `<tspan x="${x.toFixed(1)}" y="${(y + dy + height * 0.35).toFixed(1)}">${escaped(word)}</tspan>`
    })
    return `<text font-size="${height.toFixed(1)}">${lines.join('')}</text>`
  })
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${size} ${size}" width="${size}" height="${size}">
<g stroke="#fff" stroke-width="1.5" stroke-linejoin="round">
${shapes.join('\n')}
</g>
<path d="${root.children.map(pathOf).join('')}" fill="none" stroke="#2a3140" stroke-width="2.5" stroke-linejoin="round"/>
<g font-family="sans-serif" text-anchor="middle" fill="#1d2430" pointer-events="none">
${texts.join('\n')}
</g>
</svg>
`
}

function pathOf({ polygon }) {
  return `M${polygon.map(([x, y]) => `${x.toFixed(2)},${y.toFixed(2)}`).join('L')}Z`
}

function centroidOf(polygon) {
  let [twice, sumX, sumY] = [0, 0, 0]
  polygon.forEach(([x, y], k) => {
    const [u, v] = polygon[(k + 1) % polygon.length]
    const cross = x * v - u * y
    twice += cross
    sumX += cross * (x + u)
    sumY += cross * (y + v)
  })
  return { x: sumX / (3 * twice), y: sumY / (3 * twice) }
}

function escaped(text) {
  return text.replace(/[&<>"]/g, (character) => `&#${character.charCodeAt(0)};`)
}
