// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "circle_voronoi/cells.h"
#include "circle_voronoi/convex_polygon.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/limits.h"
#include "clip.h"

namespace circle_voronoi {

/// The limits of the parts of cells and edges that are kept: a region, a distance from the nearest circle, or both. The
/// functions below are exported because the library for files calls them.
struct Limits {
  const ConvexPolygon* region = nullptr;
  std::optional<double> maxDistance = {};

  /// Returns the radius of the disc around the center of a circle that the distance keeps. It may be negative.
  double reachFrom(const Diagram& diagram, CircleIndex circle) const {
    const double r = diagram.metric == Metric::circles ? diagram.circles[static_cast<std::size_t>(circle)].r : 0;
    return r + *maxDistance;
  }
};

/// Errors: badOption if there is a maximum distance that is not finite, or exceeds kRegionLimit.
inline Result<void> checkMaxDistance(std::optional<double> distance) {
  if (!distance || std::abs(*distance) <= kRegionLimit) return {};
  return Error{ErrorCode::badOption, kNone,
               std::string("The maximum distance must be finite and at most ") + kRegionLimitText + "."};
}

/// Returns the part of an edge within the distance. Without a distance, returns the edge with infinite ends replaced by
/// ends far outside the region.
std::optional<CurvePart> partAtDistance(const Diagram& diagram, EdgeIndex edge, const Limits& limits);

/// Returns the kept parts of an edge, in its direction.
CIRCLE_VORONOI_API std::vector<CurvePart> keptParts(const Diagram& diagram, EdgeIndex edge, const Limits& limits);

/// Returns the outline of the kept part of a cell.
CIRCLE_VORONOI_API Outline limitedOutline(const Diagram& diagram, CircleIndex circle, const Limits& limits);

}  // namespace circle_voronoi
