// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "dual.h"
#include "vectors.h"

namespace circle_voronoi {

/// The Delaunay triangulation of points, any number of them, in any position.
/// Equal points share one corner; ties of four co-circular points are broken by coordinates, so the triangulation does
/// not depend on the order of the points. Fast if points near in the plane are near in the list (spatial_order.h).
struct Delaunay {
  Dual dual;  ///< faces in the order of their smallest corner
  /// For each point the point that stands for it as a corner: itself, or an equal one.
  std::vector<int> representative;
};
Delaunay delaunay(std::span<const Point> points);

/// The same triangulation as its edges alone, each once.
struct DelaunayEdges {
  std::vector<std::array<int, 2>> edges;
  std::vector<int> representative;
};
DelaunayEdges delaunayEdges(std::span<const Point> points);

}  // namespace circle_voronoi
