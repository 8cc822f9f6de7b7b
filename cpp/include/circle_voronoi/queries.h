// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/diagram.h"

namespace circle_voronoi {

// Questions about circles that a diagram of Metric::circles answers, each in linear time. The triangles of the dual are
// `Diagram::vertexCircles`. Two triangles may share two or all three circles, so the dual is a quasi-triangulation.

/// Returns the pairs of circles whose cells share an edge. Each pair occurs once, with the smaller index first, and the
/// pairs are in increasing order.
[[nodiscard]] CIRCLE_VORONOI_API std::vector<std::array<CircleIndex, 2>> neighborPairs(const Diagram& diagram);

/// Two circles and the gap between them.
struct ClosestPair {
  CircleIndex first = {};  ///< the smaller index
  CircleIndex second = {};
  double gap = 0;  ///< |c - c'| - r - r'; negative if the two overlap
};

/// Returns the two visible circles with the smallest gap. Returns nothing if fewer than two circles are visible.
///
/// The two share an edge: if a circle k were nearer than gap / 2 to the middle of their gap, k would have a smaller gap
/// to each.
[[nodiscard]] CIRCLE_VORONOI_API std::optional<ClosestPair> closestPair(const Diagram& diagram);

/// A disc and the circles that it touches.
struct EmptyDisc {
  Vertex disc;
  /// The circles it touches, up to three. The remaining entries are kNone.
  std::array<CircleIndex, 3> circles;
};

/// Returns the largest disc that has its center in the convex hull of the circles (hull.h) and overlaps no circle. Its
/// radius is not negative. Returns nothing if there are no circles. ClippedDiagram::largestEmptyDisc and
/// region_queries.h find the largest disc in a box or another region.
[[nodiscard]] CIRCLE_VORONOI_API std::optional<EmptyDisc> largestEmptyDiscCenteredInHull(const Diagram& diagram);

}  // namespace circle_voronoi
