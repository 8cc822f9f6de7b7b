// SPDX-License-Identifier: GPL-3.0-or-later
#include "order.h"

#include <utility>

#include "centres.h"
#include "spatial_order.h"

namespace circle_voronoi {

OrderedCircles order(std::span<const Circle> circles) {
  OrderedCircles ordered;
  ordered.indices = spatialOrder(centresOf(circles));
  ordered.circles.reserve(circles.size());
  for (const int i : ordered.indices) ordered.circles.push_back(circles[i]);
  return ordered;
}

}  // namespace circle_voronoi
