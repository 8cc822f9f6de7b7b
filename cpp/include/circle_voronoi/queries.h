// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/convex_polygon.h"
#include "circle_voronoi/diagram.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

// What the diagram of Metric::circles tells about its circles, each in linear time. The dual's triangles are
// `Diagram::vertexCircles`; two of them may share two circles or all three, so it is a quasi-triangulation.

/// The pairs of circles whose cells share an edge, the smaller index first, in increasing order, each once.
std::vector<std::array<CircleIndex, 2>> neighborPairs(const Diagram& diagram);

struct ClosestPair {
  CircleIndex first = {};  ///< the smaller index
  CircleIndex second = {};
  double gap = 0;  ///< |c - c'| - r - r': negative if the two overlap
};

/// The two visible circles with the smallest gap; none if fewer than two are visible.
///
/// They share an edge: a circle k nearer than gap / 2 to the middle of their gap would have a smaller gap to each.
std::optional<ClosestPair> closestPair(const Diagram& diagram);

struct EmptyDisc {
  Vertex disc;
  /// The circles it touches, of up to three of them; kNone in place of the others.
  std::array<CircleIndex, 3> circles;
};

/// The largest disc that meets no circle but for touching, of those with their centre inside a region, which they may
/// stick out of: the place in the region that is farthest from all circles. Its radius is negative if circles cover the
/// region. None if there are no circles.
///
/// The distance from the nearest circle is largest at a vertex, where an edge crosses the boundary, or at a corner: in
/// a cell it is convex along every line.
std::optional<EmptyDisc> largestEmptyDiscCenteredIn(const Diagram& diagram, const ConvexPolygon& region);

/// The same inside the convex hull of the circles (hull.h). Its radius is not negative.
std::optional<EmptyDisc> largestEmptyDiscCenteredInHull(const Diagram& diagram);

/// The largest disc that meets no circle but for touching, of those that lie inside a region as a whole; it may touch
/// sides of the region in place of circles. Where circles cover the region there is none: then it is that of
/// largestEmptyDiscCenteredIn, whose radius is not above 0. None if there are no circles. Each circle is tried with
/// each of the segments, some two for each side, of the region's medial axis.
std::optional<EmptyDisc> largestEmptyDiscInside(const Diagram& diagram, const ConvexPolygon& region);

}  // namespace circle_voronoi
