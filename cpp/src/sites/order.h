// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "circle_voronoi/circle.h"
#include "threads.h"

namespace circle_voronoi {

struct OrderedCircles {
  std::vector<Circle> circles;  ///< neighbors near one another
  std::vector<int> indices;     ///< of each its index in the input
};

/// The circles by the spatial order of their centers (spatial_order.h); those with the same center as they came.
OrderedCircles order(std::span<const Circle> circles, Threads threads = Threads());

}  // namespace circle_voronoi
