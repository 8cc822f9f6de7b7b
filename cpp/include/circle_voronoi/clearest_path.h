// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/point.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// A path among circles that keeps as far from all of them as any path between its ends can.
struct ClearestPath {
  /// The least distance from a circle along the path; negative if the path cannot but enter circles.
  double clearance = 0;
  /// The edges to follow, in order. The first is followed from `entry`, the last up to `exit`. Where the path goes
  /// around everything, an edge that leads to infinity is followed by one that comes back.
  std::vector<EdgeIndex> edges;
  /// Where the path from p meets an edge, straight away from the centre of the circle nearest to p, and where it leaves
  /// an edge for q. None if the way leads straight to infinity.
  std::optional<Point> entry;
  std::optional<Point> exit;
};

/// The path of greatest clearance from p to q, in O(n log n). The cells are those of Metric::circles, of one circle or
/// more.
///
/// To move straight away from the nearest centre until an edge is met never loses clearance. As that carries every path
/// onto the edges, infinity included, some path along edges is as clear as any: that of greatest bottleneck (Dijkstra).
ClearestPath clearestPath(const Diagram& diagram, Point p, Point q);

}  // namespace circle_voronoi
