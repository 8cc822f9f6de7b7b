// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/limits.h"
#include "weighted_point.h"

namespace circle_voronoi {

/// Returns the radius of a circle, or the root of the weight that it has in a power diagram, with the weight's sign.
inline double radiusOf(const Diagram& diagram, const Circle& c) {
  const bool isRoot = diagram.metric == Metric::power && diagram.weights;
  return isRoot ? std::copysign(std::sqrt(std::abs(c.r)), c.r) : c.r;
}

/// Returns the radius of the disc around the center of a circle that a maximum distance keeps. It may be negative. For
/// the metric `power` it is the root of the weight plus the signed square of the distance, right to rounding of itself,
/// or 0 if that is negative.
inline double reachFrom(const Diagram& diagram, CircleIndex circle, double maxDistance) {
  const Circle& c = diagram.circles[static_cast<std::size_t>(circle)];
  if (diagram.metric != Metric::power) return (diagram.metric == Metric::circles ? c.r : 0) + maxDistance;
  const TwoPart weight = powerWeight(c, diagram.weights);
  const TwoPart own = square(maxDistance);
  const double sign = maxDistance < 0 ? -1 : 1;
  const TwoPart whole = sum(weight.value, sign * own.value);
  return std::sqrt(std::max(whole.value + (whole.rest + (weight.rest + sign * own.rest)), 0.0));
}

/// Errors: badOption if there is a maximum distance that is not finite, or exceeds kRegionLimit.
inline Result<void> checkMaxDistance(std::optional<double> distance) {
  if (!distance || std::abs(*distance) <= kRegionLimit) return {};
  return Error{ErrorCode::badOption, kNone,
               std::string("The maximum distance must be finite and at most ") + kRegionLimitText + "."};
}

}  // namespace circle_voronoi
