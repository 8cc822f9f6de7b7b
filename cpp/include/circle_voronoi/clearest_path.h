// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/curve.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/point.h"

namespace circle_voronoi {

/// A path of greatest clearance: no other path between the same two points stays farther from all circles.
struct ClearestPath {
  /// The smallest distance from a circle along the path; negative if every path enters a circle.
  double clearance = 0;
  /// The edges to follow, in order. The path joins the first one at `entry` and leaves the last one at `exit`. If the
  /// path goes around everything, an edge that leads to infinity is followed by one that comes back.
  std::vector<EdgeIndex> edges;
  /// The point where the path from p meets the first edge. It gets there straight away from the center of the circle
  /// nearest to p. Empty if that leads straight to infinity.
  std::optional<Point> entry;
  /// The point where the path leaves the last edge for q. Empty if q is reached straight from infinity.
  std::optional<Point> exit;
  /// With a region (region_queries.h), the curves of the whole path from p to q. Each ends where the next one starts.
  /// Parts of edges are arcs, and the others are straight. Empty without a region, and if p and q are the same.
  std::vector<EdgeCurve> curves = {};
  /// For each of these curves the edge that it is a part of; kNone if it is on no edge.
  std::vector<EdgeIndex> curveEdges = {};
};

/// Returns a path of greatest clearance from p to q. O(n log n).
///
/// If you move straight away from the nearest center until you meet an edge, you never lose clearance. This carries
/// every path onto the edges, infinity included. Hence the path along edges with the greatest bottleneck is as clear as
/// any path. Dijkstra's algorithm finds it.
///
/// Precondition: the metric is Metric::circles, and there is at least one circle.
[[nodiscard]] CIRCLE_VORONOI_API ClearestPath clearestPath(const Diagram& diagram, Point p, Point q);

}  // namespace circle_voronoi
