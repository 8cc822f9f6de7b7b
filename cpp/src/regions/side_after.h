// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "at.h"
#include "circle_voronoi/region.h"

namespace circle_voronoi {

/// Returns the side of a region that follows a side in its ring.
inline RegionSideIndex sideAfter(const Region& region, RegionSideIndex side, RegionRingIndex ring) {
  const auto offsets = region.ringOffsets();
  return side + 1 == offsets[at(ring) + 1] ? offsets[at(ring)] : side + 1;
}
inline RegionSideIndex sideAfter(const Region& region, RegionSideIndex side) {
  return sideAfter(region, side, region.ringOf(side));
}

}  // namespace circle_voronoi
