// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/clearest_path.h"
#include "circle_voronoi/region.h"
#include "rings.h"

// Checks of clearest paths inside regions, for tests and a fuzzer.
namespace circle_voronoi::test {

/// Returns the least distance of a segment from circles.
double clearanceAlong(std::span<const Circle> circles, Point a, Point b);

/// The parts of a region: polygons that touch are one part.
class PartsOfRegion {
 public:
  explicit PartsOfRegion(const Region& region);
  /// Returns whether two points of the region lie in the same part.
  bool areTogether(Point p, Point q);

 private:
  std::size_t partOf(Point p);
  std::size_t find(std::size_t k);

  std::vector<std::size_t> parents_;
  std::vector<Region> polygons_;
};

/// Returns what is wrong with a path from p to q: a gap between its curves, a place outside the region by more than
/// rounding, or another clearance than it says. Returns an empty text if nothing is wrong.
std::string faultOf(const Region& region, std::span<const Circle> circles, Point p, Point q, const ClearestPath& path,
                    double tolerance);

}  // namespace circle_voronoi::test
