// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "delaunay.h"

namespace circle_voronoi {

/// The circles split into those with a cell and those without.
struct Visibility {
  std::vector<int> visible;          ///< increasing
  std::vector<HiddenCircle> hidden;  ///< increasing in `circle`; `by` is visible
};

/// Finds the circles that another contains. `centres` is the Delaunay triangulation of all centres.
Visibility hide(std::span<const Circle> circles, const Delaunay& centres);

}  // namespace circle_voronoi
