// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "delaunay.h"
#include "hiders.h"
#include "order.h"

namespace circle_voronoi {

/// The visible circles, which have a cell, and the hidden circles, which another one contains. Every construction
/// starts from these.
struct Sites {
  std::vector<Circle> circles;       ///< the visible circles, in the order given
  std::vector<int> indices;          ///< the index of each visible circle in the input
  std::vector<HiddenCircle> hidden;  ///< by input indices, increasing in `circle`
  Dual centers;                      ///< the Delaunay triangulation of their centers if it is known; otherwise empty
  std::int64_t steps = 0;  ///< steps of the search for hidden circles: boxes and circles visited, edges flipped
};

/// Removes the hidden circles. This is exact: of identical circles the first stays, and a circle that touches another
/// from inside is hidden. Returns nothing if the search for hiders takes more than `mostSteps`; otherwise it may use up
/// the given circles.
std::optional<Sites> hide(OrderedCircles& ordered, std::int64_t mostSteps, Threads threads = Threads());

/// Returns the circles without a hider, and names the hiders of the others.
Sites withoutHidden(const OrderedCircles& ordered, const Hiders& found);

}  // namespace circle_voronoi
