// SPDX-License-Identifier: GPL-3.0-or-later
// A notebook cell, as in Observable or Jupyter's HTML output, imports a module and returns an element.
await import('../../../dist/element/classic.js')

const figure = document.createElement('circle-voronoi')
figure.circles = Array.from({ length: 12 }, (_, k) => ({ x: (k * 7) % 12, y: (k * 5) % 9, r: 0.2 + (k % 3) / 4 }))
figure.layers = { dual: true }
figure.controls = true
figure.addEventListener('circleschange', ({ detail }) => {
  const radii = detail.circles.filter((_, k) => k % 3 === 2)
  document.querySelector('output').textContent = Math.max(...radii)
})
document.querySelector('#cell').append(figure)
console.assert(figure instanceof circleVoronoi.CircleVoronoiElement)
