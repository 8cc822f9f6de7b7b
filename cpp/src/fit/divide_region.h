// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "circle_voronoi/point.h"
#include "circle_voronoi/region.h"

namespace circle_voronoi {

/// Divides a region by lines into parts with areas in proportion to `shares`, which are positive, and returns a point
/// in the middle of each. A part is cut across its longer side, with the larger shares on one side, until each share
/// has its own. The points lie in the region but for rounding, and may be equal only where parts are as small as that.
std::vector<Point> middlesOfParts(const Region& region, std::span<const double> shares);

}  // namespace circle_voronoi
