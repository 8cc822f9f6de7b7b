// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/region.h"

namespace circle_voronoi {

/// Returns a region times a power of two, which is 1 or larger.
Region scaledRegion(const Region& region, double factor);

}  // namespace circle_voronoi
