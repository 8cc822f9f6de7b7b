// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi_families/families.h"

namespace circle_voronoi::test {

/// Whether distances or areas of a family cannot be compared as doubles of one box: the smallest are below the rounding
/// of the largest. Other tests compare the diagrams of these families with exact ones.
inline bool isTooWideToDraw(Family family) {
  return family == Family::farOutlier || family == Family::growingLine || family == Family::tangentChain;
}

}  // namespace circle_voronoi::test
