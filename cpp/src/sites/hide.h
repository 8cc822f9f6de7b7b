// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "dual.h"

namespace circle_voronoi {

/// The circles that have a cell, and those that another circle contains.
struct Sites {
  std::vector<Circle> circles;       ///< the visible ones, neighbours near one another (spatial_order.h)
  std::vector<int> indices;          ///< of each its index in the input
  std::vector<HiddenCircle> hidden;  ///< by input indices, increasing in `circle`; `by` is visible
  Dual centres;                      ///< the Delaunay triangulation of the visible circles' centres
};

/// Sorts out the hidden circles. Exact: of identical circles the first stays, a tangent circle inside is hidden.
Sites hide(std::span<const Circle> circles);

}  // namespace circle_voronoi
