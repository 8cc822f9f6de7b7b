// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "dual.h"
#include "hide.h"

namespace circle_voronoi {

/// What every construction starts from.
struct Sites {
  std::vector<Circle> circles;       ///< the visible ones, neighbours near one another
  std::vector<int> indices;          ///< of each its index in the input
  std::vector<HiddenCircle> hidden;  ///< by input indices, increasing in `circle`
  Dual centres;                      ///< the Delaunay triangulation of their centres; empty where `dual` is there
  std::optional<Dual> dual;          ///< the dual of their Voronoi diagram, proven, if it took that to find them
  std::int64_t flips = 0;            ///< that `dual` took
  FilterCounts signs;                ///< that `dual` and its proof took
};

/// Triangulates the centres of visible circles, unless their diagram is there.
Sites triangulate(VisibleCircles visible, Threads threads = Threads());

}  // namespace circle_voronoi
