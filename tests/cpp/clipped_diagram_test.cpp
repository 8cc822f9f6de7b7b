// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/clipped_diagram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <tuple>

#include "circle_voronoi/comparison.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/finder.h"
#include "circle_voronoi_families/families.h"
#include "in_outline.h"
#include "region_shapes.h"
#include "report.h"

namespace circle_voronoi {
namespace {

using test::hardRegions;
using test::RegionShape;
using test::seedOr;

double sumOf(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// Circles in the unit square, on a grid, in each other, with one huge.
std::vector<std::pair<std::string, std::vector<Circle>>> inputs(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<std::pair<std::string, std::vector<Circle>>> all;
  auto& few = all.emplace_back("few", std::vector<Circle>()).second;
  for (int i = 0; i < 5; ++i) few.push_back({unit(random), unit(random), 0.1 * unit(random)});
  auto& many = all.emplace_back("many", std::vector<Circle>()).second;
  for (int i = 0; i < 300; ++i) many.push_back({unit(random), unit(random), 0.03 * unit(random)});
  auto& grid = all.emplace_back("grid", std::vector<Circle>()).second;
  for (int i = 0; i < 10; ++i) {
    for (int j = 0; j < 10; ++j) grid.push_back({2.0 * i, 2.0 * j, 0.5});
  }
  auto& mixed = all.emplace_back("grid of two sizes", std::vector<Circle>()).second;
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 8; ++j) mixed.push_back({4.0 * i, 3.0 * j, (i + j) % 2 == 0 ? 1.0 : 0.25});
  }
  auto& huge = all.emplace_back("one huge", std::vector<Circle>{{0.5, 0.5, 0.3}}).second;
  for (int i = 0; i < 100; ++i) huge.push_back({unit(random), unit(random), 0.01 * unit(random)});
  auto& overlapping = all.emplace_back("overlapping", std::vector<Circle>()).second;
  for (int i = 0; i < 60; ++i) overlapping.push_back({unit(random), unit(random), 0.4 * unit(random)});
  auto& far = all.emplace_back("far from the origin", std::vector<Circle>()).second;
  for (int i = 0; i < 40; ++i) far.push_back({1e6 + unit(random), -3e6 + unit(random), 0.05 * unit(random)});
  all.emplace_back("one", std::vector<Circle>{{0.3, 0.4, 0.1}});
  all.emplace_back("two", std::vector<Circle>{{0.3, 0.4, 0.1}, {0.8, 0.3, 0.02}});
  all.emplace_back("three in a row", std::vector<Circle>{{0, 0, 0.1}, {1, 0, 0.1}, {2, 0, 0.1}});
  return all;
}

/// Calls `check` with many diagrams and regions that are hard for them.
template <class Check>
void forHardRegions(Check check) {
  const std::uint64_t seed = seedOr(30);
  std::mt19937_64 random(seed);
  for (const auto& [name, circles] : inputs(random)) {
    for (const Metric metric : {Metric::circles, Metric::centers, Metric::power}) {
      const Diagram diagram = computeComparison(circles, metric).value();
      for (const RegionShape& shape : hardRegions(diagram, random)) {
        SCOPED_TRACE(name + ", " + std::string(metricName(metric)) + ", " + shape.name + ", seed " +
                     std::to_string(seed));
        const auto clipped = ClippedDiagram::from(diagram, shape.region);
        ASSERT_TRUE(clipped) << clipped.error().message;
        check(diagram, shape.region, *clipped);
      }
    }
  }
}

TEST(ClippedDiagram, AreasSumToThatOfTheRegion) {
  forHardRegions([](const Diagram&, const Region& region, const ClippedDiagram& clipped) {
    const double area = region.area();
    const Box box = region.bounds();
    // For regions that are thinner than rounding.
    const double thin = 1e-16 * region.perimeter() * (box.maxX - box.minX + box.maxY - box.minY);
    EXPECT_NEAR(sumOf(clipped.areas()), area, 1e-12 * area + thin);
  });
}

TEST(ClippedDiagram, OutlinesAreClosedAndShareTheirPoints) {
  forHardRegions([](const Diagram& diagram, const Region&, const ClippedDiagram& clipped) {
    // Of each piece of an edge, in the direction of the edge: its ends, and how often it occurs.
    std::map<std::tuple<std::int32_t, double, double, double, double>, std::array<int, 2>> pieces;
    for (std::size_t i = 0; i < diagram.circles.size(); ++i) {
      for (const auto& loop : clipped.outline(static_cast<std::int32_t>(i))) {
        for (std::size_t k = 0; k < loop.size(); ++k) {
          const EdgeCurve& curve = loop[k].curve;
          EXPECT_EQ(curve.end, loop[(k + 1) % loop.size()].curve.start);
          if (loop[k].side == kNone) continue;
          const bool isAlong = loop[k].side % 2 == 0;
          const Point start = isAlong ? curve.start : curve.end;
          const Point end = isAlong ? curve.end : curve.start;
          ++pieces[{Diagram::edgeOf(loop[k].side), start.x, start.y, end.x, end.y}][isAlong ? 0 : 1];
        }
      }
    }
    for (const auto& [piece, count] : pieces) EXPECT_EQ(count[0], count[1]);
  });
}

TEST(ClippedDiagram, AreasAreThoseOfTheOutlines) {
  forHardRegions([](const Diagram&, const Region& region, const ClippedDiagram& clipped) {
    const std::vector<double> areas = clipped.areas();
    const Box box = region.bounds();
    const double farthest = std::max({std::abs(box.minX), std::abs(box.minY), std::abs(box.maxX), std::abs(box.maxY)});
    const double rounding = 1e-14 * farthest * region.perimeter();
    for (std::size_t i = 0; i < areas.size(); ++i) {
      EXPECT_NEAR(area(clipped.outline(static_cast<std::int32_t>(i))), areas[i], rounding);
    }
  });
}

TEST(ClippedDiagram, ContainsWhatIsInTheRegionAndNearest) {
  std::mt19937_64 random(seedOr(31));
  forHardRegions([&](const Diagram& diagram, const Region& region, const ClippedDiagram& clipped) {
    const Finder finder(diagram);
    const Box box = region.bounds();
    std::uniform_real_distribution<double> x(box.minX, box.maxX);
    std::uniform_real_distribution<double> y(box.minY, box.maxY);
    for (int k = 0; k < 40; ++k) {
      const Point p = {x(random), y(random)};
      const CircleIndex nearest = finder.find(p);
      double least = 1e300;
      for (const SideIndex side : diagram.sides(nearest)) {
        least = std::min(least, lead(diagram, nearest, diagram.neighborOf(side), p));
      }
      if (least < 1e-9 * (std::abs(p.x) + std::abs(p.y))) continue;
      bool isInside = false;
      for (const auto& loop : clipped.outline(nearest)) isInside ^= hasInLoop(loop, p);
      EXPECT_EQ(isInside, region.contains(p)) << p.x << " " << p.y << " in " << nearest;
    }
  });
}

}  // namespace
}  // namespace circle_voronoi
