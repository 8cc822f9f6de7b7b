// SPDX-License-Identifier: GPL-3.0-or-later
// Regions take n log n steps in their sides and the places where these meet. Each step of a fit takes more, as its
// header says.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "circle_voronoi/compute.h"
#include "circle_voronoi/fit_areas.h"
#include "circle_voronoi/region.h"
#include "circle_voronoi/treemap.h"
#include "growth.h"
#include "steps.h"

namespace circle_voronoi::test {
namespace {

/// Each polygon of an input twice, the second time moved by less than the distance of corners.
GrowthInput twice(GrowthInput input) {
  const std::size_t count = input.polygons.size();
  const double step = 0.1 / static_cast<double>(input.circles.size());
  for (std::size_t k = 0; k < count; ++k) {
    input.polygons.push_back(input.polygons[k]);
    for (Region::Ring& ring : input.polygons.back()) {
      for (Point& p : ring) p = {p.x + step, p.y};
    }
  }
  return input;
}

/// Squares of a grid, which share their sides.
GrowthInput squares(std::size_t size) {
  GrowthInput input;
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(size)));
  for (std::size_t k = 0; k < side * side; ++k) {
    const auto x = static_cast<double>(k % side);
    const auto y = static_cast<double>(k / side);
    input.polygons.push_back({{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}});
  }
  return input;
}

constexpr std::array kSquares = {GrowthFamily{"squares", squares}};

auto dissolved(const GrowthInput& input) {
  return [polygons = input.polygons] { EXPECT_TRUE(Region::fromPolygons(polygons, {.dissolve = true})); };
}

TEST(GrowthOfRegions, OfValidation) {
  expectGrowth({"Region::fromPolygons", "region.h", [](const GrowthInput& input) {
                  return [polygons = input.polygons] { EXPECT_TRUE(Region::fromPolygons(polygons)); };
                }});
}

TEST(GrowthOfRegions, OfRingsInAnyOrder) {
  expectGrowth({"Region::fromRings", "region.h", [](const GrowthInput& input) {
                  std::vector<Region::Ring> rings;
                  for (const auto& polygon : input.polygons) rings.insert(rings.end(), polygon.begin(), polygon.end());
                  return [rings] { EXPECT_TRUE(Region::fromRings(rings)); };
                }});
}

TEST(GrowthOfRegions, OfDissolving) {
  expectGrowth({"RegionOptions::dissolve", "region.h", dissolved});
  expectGrowth({"RegionOptions::dissolve", "region.h", dissolved, kSquares});
  // m log^2 m at the number of corners of the hub.
  constexpr double kMost = 5.5;
  expectGrowth({"RegionOptions::dissolve of copies", "region.h",
                [](const GrowthInput& input) { return dissolved(twice(input)); }, growthFamilies(), 1000, kMost});
}

/// A promise of region.h about a question that is asked at each corner of a region.
Promise atCorners(std::string_view function, std::span<const GrowthFamily> families,
                  const std::function<void(const Region& region, const Point& corner)>& ask, std::size_t size = 1000) {
  return {function, "region.h",
          [ask](const GrowthInput& input) {
            return [ask, region = kept(input.region())] {
              for (const Point& corner : region->points()) ask(*region, corner);
            };
          },
          families, size};
}

// The line from a point crosses many strips, turns of a spiral, and holes.
TEST(GrowthOfRegions, OfPoints) {
  static const std::array kFamilies = {kUniform, kHub, kComb};
  // One more level of runs counts for more where there are fewer sides.
  constexpr std::size_t kSize = 4000;
  const auto ask = [](const Region& region, const Point& corner) {
    EXPECT_TRUE(region.contains(corner));
    static_cast<void>(region.contains({0.9 * corner.x, 0.9 * corner.y}));
  };
  expectGrowth(atCorners("Region::contains", kFamilies, ask, kSize));
}

// Nearly all strips have boxes around each of their corners.
TEST(GrowthOfRegions, OfBoxes) {
  static const std::array kFamilies = {kUniform, kHub, kComb, kHoles};
  expectGrowth(atCorners("Region::sidesIn, sidesNear", kFamilies, [](const Region& region, const Point& corner) {
    EXPECT_FALSE(region.sidesIn({corner.x, corner.y, corner.x, corner.y}).empty());
    EXPECT_FALSE(region.sidesNear(std::array{corner}, 0).empty());
  }));
}

/// The steps of each of Newton's steps of a fit to equal areas.
double stepsOfFit(const GrowthInput& input, const Region& region) {
  int newtonSteps = 0;
  const std::vector<double> areas(input.circles.size(), 1);
  const std::int64_t steps = stepsOf([&] {
    const auto fit = fitAreas(input.circles, areas, region, {.shares = true, .tolerance = 0.1});
    ASSERT_TRUE(fit) << fit.error().message;
    newtonSteps = fit.value().steps;
  });
  return static_cast<double>(steps) / std::max(1, newtonSteps);
}

// A step of a fit solves a sparse system in n^1.5 steps.
TEST(GrowthOfRegions, OfFits) {
  constexpr double kMost = 8;
  for (const GrowthFamily& family : growthFamilies().first(5)) {
    expectGrowth(
        family.name, 250,
        [&](std::size_t size) {
          const GrowthInput input = family.make(size);
          return stepsOfFit(input, input.region());
        },
        kMost);
  }
}

// Each node has about as many children, so that the fits are as large.
TEST(GrowthOfRegions, OfTreemaps) {
  expectGrowth("tree", 500, [](std::size_t size) {
    constexpr std::size_t kChildren = 12;
    std::vector<TreemapNode> nodes = {{-1, 0}};
    for (std::size_t i = 1; i < size; ++i) {
      nodes.push_back({static_cast<std::int32_t>((i - 1) / kChildren), 1.0 + static_cast<double>(i % 17)});
    }
    const Region square = Region::from(Box{0, 0, 1, 1}).value();
    return static_cast<double>(stepsOf([&] { (void)treemap(nodes, square).value(); }));
  });
}

}  // namespace
}  // namespace circle_voronoi::test
