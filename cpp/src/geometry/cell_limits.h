// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/limits.h"

namespace circle_voronoi {

/// Returns the radius of a circle, or the root of the weight that it has in a power diagram, with the weight's sign.
inline double radiusOf(const Diagram& diagram, const Circle& c) {
  const bool isRoot = diagram.metric == Metric::power && diagram.weights;
  return isRoot ? std::copysign(std::sqrt(std::abs(c.r)), c.r) : c.r;
}

/// Returns the radius of the disc around the center of a circle that a maximum distance keeps. It may be negative.
inline double reachFrom(const Diagram& diagram, CircleIndex circle, double maxDistance) {
  const double r = diagram.metric == Metric::circles ? diagram.circles[static_cast<std::size_t>(circle)].r : 0;
  return r + maxDistance;
}

/// Errors: badOption if there is a maximum distance that is not finite, or exceeds kRegionLimit.
inline Result<void> checkMaxDistance(std::optional<double> distance) {
  if (!distance || std::abs(*distance) <= kRegionLimit) return {};
  return Error{ErrorCode::badOption, kNone,
               std::string("The maximum distance must be finite and at most ") + kRegionLimitText + "."};
}

}  // namespace circle_voronoi
