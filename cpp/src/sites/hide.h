// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "delaunay.h"
#include "order.h"
#include "predicates.h"
#include "proof.h"

namespace circle_voronoi {

/// The visible circles, which have a cell, and the hidden circles, which another one contains. Every construction
/// starts from these.
struct Sites {
  std::vector<Circle> circles;       ///< the visible circles, in the order given
  std::vector<int> indices;          ///< the index of each visible circle in the input
  std::vector<HiddenCircle> hidden;  ///< by input indices, increasing in `circle`
  Dual centers;                      ///< the Delaunay triangulation of their centers if it is known; otherwise empty
  std::optional<Dual> dual;          ///< the dual of their Voronoi diagram, if `hide` constructed it
  Proof proof;                       ///< the proof of `dual`
  std::int64_t steps = 0;            ///< the steps of `hide`: boxes and circles visited, edges flipped
  std::int64_t flips = 0;            ///< the edges flipped by the construction of `dual`, part of `steps`
  FilterCounts signs;                ///< the signs computed for `dual` and its proof
};

/// The limit of the search for hiders, in steps per circle. Ordinary circles take ten to twenty.
inline constexpr std::int64_t kMostStepsACircle = 30;

/// Removes the hidden circles. This is exact: of identical circles the first stays, and a circle that touches another
/// from inside is hidden. A search finds a circle that contains each hidden one. If it takes more than 1000 steps plus
/// `mostStepsACircle` for each circle, the construction of the Voronoi diagram finds the hidden circles instead
/// (insert.h).
Sites hide(OrderedCircles ordered, std::int64_t mostStepsACircle = kMostStepsACircle, Threads threads = Threads());

}  // namespace circle_voronoi
