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

/// The circles that have a cell, and those that another circle contains: what every construction starts from.
struct Sites {
  std::vector<Circle> circles;       ///< the visible ones, in the order they came
  std::vector<int> indices;          ///< of each its index in the input
  std::vector<HiddenCircle> hidden;  ///< by input indices, increasing in `circle`
  Dual centers;                      ///< their centers' Delaunay triangulation, if it is known; else empty
  std::optional<Dual> dual;          ///< the dual of their Voronoi diagram, if it took that to find them
  Proof proof;                       ///< of `dual`
  std::int64_t steps = 0;            ///< taken to find them: boxes and circles looked at, edges flipped
  std::int64_t flips = 0;            ///< of these, the edges that the construction of `dual` flipped
  FilterCounts signs;                ///< that `dual` and its proof took
};

/// A search for hiders of ordinary circles takes ten to twenty.
inline constexpr std::int64_t kMostStepsACircle = 30;

/// Takes out the hidden circles. Exact: of identical circles the first stays, a tangent circle inside is hidden.
/// A search for what contains each circle tells them, or, where it takes more steps than those given and 1000, the
/// construction of their Voronoi diagram (insert.h).
Sites hide(OrderedCircles ordered, std::int64_t mostStepsACircle = kMostStepsACircle, Threads threads = Threads());

}  // namespace circle_voronoi
