// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "circle_voronoi/circle.h"
#include "vectors.h"

namespace circle_voronoi {

inline std::vector<Point> centresOf(std::span<const Circle> circles) {
  std::vector<Point> centres;
  centres.reserve(circles.size());
  for (const Circle& c : circles) centres.push_back({c.x, c.y});
  return centres;
}

}  // namespace circle_voronoi
