// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/cells.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/convex_polygon.h"
#include "circle_voronoi/diagram.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

// What the diagram of Metric::circles tells about its circles, each in linear time. The dual's triangles are
// `Diagram::vertexCircles`; two of them may share two circles or all three, so it is a quasi-triangulation.

/// The pairs of circles whose cells share an edge, the smaller index first, in increasing order, each once.
std::vector<std::array<std::int32_t, 2>> neighborPairs(const Diagram& diagram);

struct ClosestPair {
  std::int32_t first = kNone;  ///< the smaller index
  std::int32_t second = kNone;
  double gap = 0;  ///< |c - c'| - r - r': negative if the two overlap
};

/// The two visible circles with the smallest gap; none if fewer than two are visible.
///
/// They share an edge: a circle k nearer than gap / 2 to the middle of their gap would have a smaller gap to each.
std::optional<ClosestPair> closestPair(std::span<const Circle> circles, const Diagram& diagram);

struct EmptyDisc {
  Vertex disc;
  /// The circles it touches, of up to three of them; kNone for those fewer.
  std::array<std::int32_t, 3> circles = {kNone, kNone, kNone};
};

/// The largest disc with its centre inside a region that meets no circle but for touching; its radius is negative if
/// circles cover the region. None if there are no circles.
///
/// The distance from the nearest circle is largest at a vertex, where an edge crosses the boundary, or at a corner: in
/// a cell it is convex along every line.
std::optional<EmptyDisc> largestEmptyDisc(const Cells& cells, const ConvexPolygon& region);

/// The same inside the convex hull of the circles. Its radius is not negative.
std::optional<EmptyDisc> largestEmptyDiscInHull(const Cells& cells);

}  // namespace circle_voronoi
