// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "delaunay.h"
#include "order.h"

namespace circle_voronoi {

/// The circles that have a cell, and those that another circle contains.
struct VisibleCircles {
  std::vector<Circle> circles;       ///< the visible ones, in the order they came
  std::vector<int> indices;          ///< of each its index in the input
  std::vector<HiddenCircle> hidden;  ///< by input indices, increasing in `circle`
  std::optional<Dual> centres;       ///< their centres' Delaunay triangulation, where it has shown that none is hidden
};

/// Takes out the hidden circles. Exact: of identical circles the first stays, a tangent circle inside is hidden.
VisibleCircles hide(OrderedCircles ordered);

}  // namespace circle_voronoi
