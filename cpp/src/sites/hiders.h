// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "circle_voronoi/circle.h"
#include "threads.h"

namespace circle_voronoi {

/// Circles in spatial order, and what tells equal ones apart.
struct NumberedCircles {
  std::span<const Circle> circles;
  std::span<const int> indices;
};

struct Hiders {
  std::vector<int> hider;  ///< of each inner circle the one that contains it, or kNone; empty if the search gave up
  std::int64_t steps = 0;  ///< boxes and circles looked at; the limit if the search gave up
};

/// Which of `circles` contains each of `inner`: the largest, of equal ones the one with the lowest index, of identical
/// ones only one with a lower index than its own. Both may be the same list. Gives up after `limit` steps: where most
/// circles all but hide one another, many have to be looked at for each.
Hiders findHiders(NumberedCircles circles, NumberedCircles inner, std::int64_t limit, Threads threads = Threads());

}  // namespace circle_voronoi
