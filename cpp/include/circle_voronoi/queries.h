// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/convex_polygon.h"
#include "circle_voronoi/diagram.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

// Questions about circles that a diagram of Metric::circles answers, each in linear time. The triangles of the dual are
// `Diagram::vertexCircles`. Two triangles may share two or all three circles, so the dual is a quasi-triangulation.

/// Returns the pairs of circles whose cells share an edge. Each pair occurs once, with the smaller index first, and the
/// pairs are in increasing order.
[[nodiscard]] std::vector<std::array<CircleIndex, 2>> neighborPairs(const Diagram& diagram);

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
[[nodiscard]] std::optional<ClosestPair> closestPair(const Diagram& diagram);

/// A disc and the circles that it touches.
struct EmptyDisc {
  Vertex disc;
  /// The circles it touches, up to three. The remaining entries are kNone.
  std::array<CircleIndex, 3> circles;
};

/// Returns the largest disc that has its center in a region and overlaps no circle: the point of the region farthest
/// from all circles. It may touch circles and may extend beyond the region. Its radius is negative if circles cover the
/// region. Returns nothing if there are no circles.
///
/// The distance from the nearest circle is largest at a vertex, at a crossing of an edge and the boundary, or at a
/// corner, because inside a cell it is convex along every line.
[[nodiscard]] std::optional<EmptyDisc> largestEmptyDiscCenteredIn(const Diagram& diagram, const ConvexPolygon& region);

/// Returns the largest disc that has its center in the convex hull of the circles (hull.h) and overlaps no circle. Its
/// radius is not negative. Returns nothing if there are no circles.
[[nodiscard]] std::optional<EmptyDisc> largestEmptyDiscCenteredInHull(const Diagram& diagram);

/// Returns the largest disc that lies entirely inside a region and overlaps no circle. It may touch sides of the region
/// in place of circles. Without circles it is the largest disc in the region. If circles cover the region, returns the
/// disc of largestEmptyDiscCenteredIn, whose radius is not positive. region_queries.h has this for any Region.
///
/// Each circle is tried with each of the segments of the region's medial axis, about two for each side.
[[nodiscard]] std::optional<EmptyDisc> largestEmptyDiscInside(const Diagram& diagram, const ConvexPolygon& region);

}  // namespace circle_voronoi
