// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tuple>

#include "circle_voronoi/curve.h"
#include "circle_voronoi/diagram.h"

namespace circle_voronoi {

/// An order of visible circles that does not depend on their indices.
inline std::tuple<double, double, double> orderOf(const Circle& c) { return {c.x, c.y, c.r}; }
inline std::tuple<double, double, double> orderOf(const Diagram& diagram, CircleIndex circle) {
  return orderOf(diagram.circles[static_cast<std::size_t>(circle)]);
}

/// Returns whether the first of the two circles of an edge, in the order above, is on its left.
inline bool isOrdered(const Diagram& diagram, EdgeIndex edge) {
  const Edge& its = diagram.edges[static_cast<std::size_t>(edge)];
  return orderOf(diagram, its.left) < orderOf(diagram, its.right);
}

/// Returns the curve of an edge in the direction in which the first of its two circles is on the left. Its bits depend
/// on these circles and on the vertices alone, in whatever diagram and order they are.
EdgeCurve orderedCurve(const Diagram& diagram, EdgeIndex edge);

}  // namespace circle_voronoi
