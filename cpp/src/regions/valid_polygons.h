// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/point.h"

namespace circle_voronoi {

using PointRing = std::vector<Point>;

/// A closed loop of points, with the part of a cell on its left.
struct PointLoop {
  PointRing points;
  bool isHole = false;  ///< of the last loop before it that is not
};

/// Makes polygons that are valid as the OGC and GEOS define it from the loops of one cell: outer rings first, then
/// their holes. Loops may touch themselves and each other in points, and run along themselves. Steps there and back
/// cancel, and loops are divided where they touch, so that holes which touch their outer ring stay holes. Rings without
/// area up to rounding are left out. Corners are rounded (limits.h). Takes O(n log n) steps, and more only where
/// rounding has made loops cross.
///
/// Exported because the library for files calls it.
CIRCLE_VORONOI_API std::vector<std::vector<PointRing>> validPolygons(std::vector<PointLoop> loops);

}  // namespace circle_voronoi
