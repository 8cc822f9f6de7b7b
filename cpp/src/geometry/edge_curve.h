// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/curve.h"
#include "circle_voronoi/diagram.h"

namespace circle_voronoi {

/// Returns whether the circle of smaller index is on the left of an edge.
inline bool isOrdered(const Diagram& diagram, EdgeIndex edge) {
  const Edge& its = diagram.edges[static_cast<std::size_t>(edge)];
  return its.left < its.right;
}

/// Returns the curve of an edge in the direction in which the circle of smaller index is on the left. Its bits depend
/// on the two circles and vertices alone, in whatever diagram they are.
EdgeCurve orderedCurve(const Diagram& diagram, EdgeIndex edge);

}  // namespace circle_voronoi
