// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "circle_voronoi/circle.h"
#include "threads.h"

namespace circle_voronoi {

/// Circles in spatial order, with indices that tell equal circles apart.
struct NumberedCircles {
  std::span<const Circle> circles;
  std::span<const int> indices;
};

struct Hiders {
  std::vector<int> hider;  ///< the place of the hider of each inner circle, or kNone; empty if the search gave up
  std::int64_t steps = 0;  ///< boxes and circles visited; the limit if the search gave up
};

/// Finds a hider in `circles` for each circle of `inner`: the largest circle that contains it, and of equally large
/// ones that with the lowest index. An identical circle hides it only if its index is lower. Both lists may be equal.
/// The search gives up after `limit` steps, because it must visit many circles for each one if most almost hide one
/// another.
Hiders findHiders(NumberedCircles circles, NumberedCircles inner, std::int64_t limit, Threads threads = Threads());

}  // namespace circle_voronoi
