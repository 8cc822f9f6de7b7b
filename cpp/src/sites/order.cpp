// SPDX-License-Identifier: GPL-3.0-or-later
#include "order.h"

#include <cstddef>

#include "at.h"
#include "centers.h"
#include "spatial_order.h"

namespace circle_voronoi {

OrderedCircles order(std::span<const Circle> circles, Threads threads) {
  OrderedCircles ordered;
  ordered.indices = spatialOrder(centersOf(circles), threads);
  ordered.circles.resize(circles.size());
  threads.forEach(circles.size(), [&](std::size_t i) { ordered.circles[i] = circles[at(ordered.indices[i])]; });
  return ordered;
}

}  // namespace circle_voronoi
