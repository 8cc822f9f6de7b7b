// SPDX-License-Identifier: GPL-3.0-or-later
const { loadCircleVoronoi } = require('circle-voronoi')

loadCircleVoronoi().then((library) => {
  const { vertices } = library.compute(Float64Array.of(0, 0, 1, 6, 0, 1, 0, 8, 1))
  console.log(vertices.join())
})
