// SPDX-License-Identifier: GPL-3.0-or-later
// Clearest paths and largest discs in regions take n log n steps in circles and sides.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "circle_voronoi/compute.h"
#include "circle_voronoi/region_queries.h"
#include "growth.h"

namespace circle_voronoi::test {
namespace {

/// A corridor between two circles of sides, and one circle outside.
GrowthInput ringCorridor(std::size_t size) {
  return {{{500, 0, 1}}, {{around(100, size / 2), around(90, size / 2, 0.3)}}};
}

/// A ring corridor full of small circles.
GrowthInput busyCorridor(std::size_t size) {
  GrowthInput input = ringCorridor(size / 2);
  input.circles.clear();
  for (std::size_t k = 0; k < size / 2; ++k) {
    const auto turn = static_cast<double>(k);
    const double angle = 2 * std::numbers::pi * turn / static_cast<double>(size / 2);
    const double radius = 95 + 3 * std::sin(1.7 * turn);
    input.circles.push_back({radius * std::cos(angle), radius * std::sin(angle), 0.01});
  }
  return input;
}

/// Thin diagonal strips, and one circle outside.
GrowthInput emptyStrips(std::size_t size) {
  GrowthInput input = kStrips.make(size);
  input.circles = {{-5000, 0, 1}};
  return input;
}

/// Thin streets in two directions, and one circle outside.
GrowthInput streets(std::size_t size) {
  GrowthInput input = {{{-5000, 0, 1}}, {}};
  for (std::size_t k = 0; k < size / 8; ++k) {
    const auto x = static_cast<double>(k);
    const double width = 0.2 + 0.05 * std::sin(1.7 * x);
    const double y = x - 2000;
    input.polygons.push_back({{{x, 0}, {x + width, 0}, {x + width + 300, 1000}, {x + 300, 1000}}});
    input.polygons.push_back({{{0, y}, {1000, y - 400}, {1000, y - 400 + width}, {0, y + width}}});
  }
  return input;
}

/// Thin strips of several widths with wide gaps between them, and one circle outside.
GrowthInput farStrips(std::size_t size) {
  GrowthInput input = {{{-5000, 0, 1}}, {}};
  for (std::size_t k = 0; k < size / 4; ++k) {
    const auto x = static_cast<double>(k);
    const double width = 0.01 * (1.5 + std::sin(1.7 * x));
    input.polygons.push_back({{{x, 0}, {x + width, 0}, {x + width + 1000, 1000}, {x + 1000, 1000}}});
  }
  return input;
}

constexpr std::array kCorridors = {GrowthFamily{"ring corridor", ringCorridor},
                                   GrowthFamily{"busy ring corridor", busyCorridor}};

/// A diagram and a region with the two ends of a path: corners far from each other.
struct Question {
  Diagram diagram;
  Region region;
  Point from;
  Point to;

  explicit Question(const GrowthInput& input) : diagram(compute(input.circles).value()), region(input.region()) {
    from = region.points()[0];
    to = region.points()[static_cast<std::size_t>(region.ringOffsets()[1]) / 2];
  }
};

auto pathIn(const GrowthInput& input) {
  const auto question = std::make_shared<Question>(input);
  return [question] { EXPECT_TRUE(clearestPath(question->diagram, question->from, question->to, question->region)); };
}

auto discIn(const GrowthInput& input) {
  const auto question = std::make_shared<Question>(input);
  return [question] { EXPECT_TRUE(largestEmptyDiscInside(question->diagram, question->region)); };
}

TEST(GrowthInRegions, OfClearestPaths) {
  static const std::array kFamilies = {kUniform, kStrips, kComb, kSpiral, kHoles};
  expectGrowth({"clearestPath", "region_queries.h", pathIn, kFamilies});
  expectGrowth({"clearestPath", "region_queries.h", pathIn, kCorridors});
}

TEST(GrowthInRegions, OfLargestDiscs) {
  static const std::array kFamilies = {kUniform, kHub, kSpiral, kHoles};
  expectGrowth({"largestEmptyDiscInside", "region_queries.h", discIn, kFamilies});
  static const std::array kTeeth = {kComb};
  expectGrowth({"largestEmptyDiscInside", "region_queries.h", discIn, kTeeth, 2000});
  expectGrowth({"largestEmptyDiscInside", "region_queries.h", discIn, kCorridors});
  static const std::array kBare = {kStrips, GrowthFamily{"empty strips", emptyStrips}, GrowthFamily{"streets", streets},
                                   GrowthFamily{"far strips", farStrips}};
  expectGrowth({"largestEmptyDiscInside", "region_queries.h", discIn, kBare});
}

}  // namespace
}  // namespace circle_voronoi::test
