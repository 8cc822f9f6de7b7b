// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "circle_voronoi/cells.h"
#include "circle_voronoi/convex_polygon.h"
#include "clip.h"

namespace circle_voronoi {

/// What is kept of cells and edges: what lies inside a region, up to a distance from the nearest circle, or both. The
/// library of files takes these functions from this one.
struct Limits {
  const ConvexPolygon* region = nullptr;
  std::optional<double> maxDistance = {};

  /// The radius, perhaps not above 0, of the disc around the centre of a circle that the distance keeps.
  double reachFrom(const Diagram& diagram, CircleIndex circle) const {
    const double r = diagram.metric == Metric::circles ? diagram.circles[static_cast<std::size_t>(circle)].r : 0;
    return r + *maxDistance;
  }
};

/// The parts of an edge that are kept, in its direction.
CIRCLE_VORONOI_API std::vector<Part> keptParts(const Diagram& diagram, EdgeIndex edge, const Limits& limits);

CIRCLE_VORONOI_API Outline outline(const Diagram& diagram, CircleIndex circle, const Limits& limits);

}  // namespace circle_voronoi
