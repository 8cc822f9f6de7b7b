// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/metric.h"
#include "circle_voronoi/region.h"

namespace circle_voronoi::test {

/// Computes the areas of the cells of a few circles in a region without a diagram, in long doubles: each side of the
/// region and each bisector of two circles is divided wherever it may cross anything, and the middle of each piece says
/// by brute force whose border it is. Takes about n^3 (n + m) steps. Areas are right to about 1e-8 of the square of the
/// extent, for a region as large as the circles whose sides are not tangent to edges. For others, numbers have 100
/// digits if `isLong`. With a maximum distance, cells are cut at that distance from their circles: in a power diagram
/// at points whose power is its square, or minus its square if it is negative.
std::vector<double> areasByBruteForce(const std::vector<Circle>& circles, const Region& region, Metric metric,
                                      bool isLong = false, std::optional<double> maxDistance = {});

/// The part of a cell in a region, found without a diagram.
struct IndependentCell {
  double area = 0;
  std::map<std::int32_t, double> neighbors;  ///< with the lengths of the borders, as those of chords
  std::map<std::int32_t, double> sides;      ///< the sides of the region on its border, with their lengths there
  /// The lengths of its loops, as those of chords; nothing if loops touch themselves or each other.
  std::optional<std::vector<double>> loops;
};

/// Computes the parts of the cells of a few circles in a region with numbers of 100 digits, as areasByBruteForce does.
/// `weights`: as in Options, for the power metric only.
std::vector<IndependentCell> cellsByBruteForce(const std::vector<Circle>& circles, const Region& region, Metric metric,
                                               std::optional<double> maxDistance = {}, bool weights = false);

}  // namespace circle_voronoi::test
