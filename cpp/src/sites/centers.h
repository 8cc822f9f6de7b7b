// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "circle_voronoi/circle.h"
#include "vectors.h"

namespace circle_voronoi {

inline std::vector<Point> centersOf(std::span<const Circle> circles) {
  std::vector<Point> centers;
  centers.reserve(circles.size());
  for (const Circle& c : circles) centers.push_back({c.x, c.y});
  return centers;
}

}  // namespace circle_voronoi
