// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "circle_voronoi/circle.h"
#include "threads.h"

namespace circle_voronoi {

struct OrderedCircles {
  std::vector<Circle> circles;  ///< in spatial order
  std::vector<int> indices;     ///< the index of each circle in the input
};

/// Returns the circles in the spatial order of their centers (spatial_order.h). Circles with the same center keep their
/// order.
OrderedCircles order(std::span<const Circle> circles, Threads threads = Threads());

}  // namespace circle_voronoi
