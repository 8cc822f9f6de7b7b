// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "circle_voronoi/diagram.h"
#include "three_touch_disc.h"

namespace circle_voronoi {

/// Returns a bound on how far a vertex may be off.
inline double vertexError(const Diagram& diagram, VertexIndex vertex) {
  constexpr double kRoundingOfCoordinates = 0x1p-48;
  const Vertex& v = diagram.vertices[static_cast<std::size_t>(vertex)];
  double size = 0;
  for (const CircleIndex i : diagram.vertexCircles[static_cast<std::size_t>(vertex)]) {
    const Circle& c = diagram.circles[static_cast<std::size_t>(i)];
    size += std::abs(v.x - c.x) + std::abs(v.y - c.y);
  }
  return kVertexRounding * size + kRoundingOfCoordinates * (std::abs(v.x) + std::abs(v.y));
}

}  // namespace circle_voronoi
