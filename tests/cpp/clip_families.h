// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <string>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/metric.h"
#include "circle_voronoi/region.h"

namespace circle_voronoi::test {

/// Circles, a region and a metric.
struct ClipInput {
  std::vector<Circle> circles;
  std::vector<Region::Ring> rings;
  Metric metric = Metric::circles;
};

/// Returns whether polygons are promised (docs/regions.md): the region is at most 1e6 times as large as the distance of
/// the circles from the origin.
bool hasPolygons(const ClipInput& input);

/// Inputs where the boundary of a region meets vertices and edges of a diagram exactly.
struct ClipFamily {
  const char* name;
  ClipInput (*make)(std::mt19937_64& random);
};

const std::vector<ClipFamily>& clipFamilies();

}  // namespace circle_voronoi::test
