// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "at.h"
#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/region.h"

namespace circle_voronoi {

/// Returns the polygons of a cell with their rings.
inline std::vector<std::vector<Region::Ring>> polygonsOfRow(const ClippedPolygons& all, std::size_t row) {
  std::vector<std::vector<Region::Ring>> polygons;
  for (std::size_t p = at(all.polygonOffsets[row]); p < at(all.polygonOffsets[row + 1]); ++p) {
    auto& rings = polygons.emplace_back();
    for (std::size_t r = at(all.ringOffsets[p]); r < at(all.ringOffsets[p + 1]); ++r) {
      rings.emplace_back(all.points.begin() + all.pointOffsets[r], all.points.begin() + all.pointOffsets[r + 1]);
    }
  }
  return polygons;
}

}  // namespace circle_voronoi
