// SPDX-License-Identifier: GPL-3.0-or-later
// Queries of a diagram, tiles and periodic diagrams take n log n steps, also where one circle has many neighbors.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "circle_voronoi/cells.h"
#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/compute_periodic.h"
#include "circle_voronoi/finder.h"
#include "circle_voronoi/hull.h"
#include "circle_voronoi/merged.h"
#include "circle_voronoi/periodic_diagram.h"
#include "circle_voronoi/periodic_queries.h"
#include "circle_voronoi/queries.h"
#include "growth.h"

namespace circle_voronoi::test {
namespace {

template <class Use>
void forEachCircle(const Diagram& diagram, Use use) {
  for (std::size_t i = 0; i < diagram.circles.size(); ++i) use(static_cast<std::int32_t>(i));
}

/// Points on the way from the first circle, which is the large one of the hub, to each other one.
std::vector<Point> pointsBetween(const std::vector<Circle>& circles) {
  std::vector<Point> points;
  const Circle& first = circles[0];
  for (const auto& [x, y, r] : circles) {
    for (const double share : {0.1, 0.9, 1.0}) {
      points.push_back({first.x + share * (x - first.x), first.y + share * (y - first.y)});
    }
  }
  return points;
}

TEST(GrowthOfQueries, OfAFinder) {
  for (const Metric metric : {Metric::circles, Metric::power}) {
    expectGrowth({"Finder", "finder.h",
                  [metric](const GrowthInput& input) {
                    const auto diagram = kept(compute(input.circles, {.metric = metric}).value());
                    return [diagram] {
                      const Finder finder(*diagram);
                      for (const Point& p : pointsBetween(diagram->circles)) EXPECT_NE(finder.find(p), kNone);
                      EXPECT_FALSE(finder.findAll(pointsBetween(diagram->circles)).empty());
                    };
                  },
                  circleFamilies()});
  }
}

TEST(GrowthOfQueries, OfNeighbors) {
  expectGrowth({"neighbors", "cells.h", ofDiagram([](const Diagram& diagram) {
                  forEachCircle(diagram, [&](CircleIndex i) { static_cast<void>(neighbors(diagram, i)); });
                }),
                circleFamilies()});
}

TEST(GrowthOfQueries, OfNeighborsInARegion) {
  expectGrowth({"ClippedDiagram::neighbors", "clipped_diagram.h",
                [](const GrowthInput& input) {
                  const auto diagram = kept(compute(input.circles).value());
                  const auto region = kept(input.region());
                  const auto clipped = kept(ClippedDiagram::from(*diagram, *region).value());
                  return [diagram, region, clipped] {
                    forEachCircle(*diagram, [&](CircleIndex i) { static_cast<void>(clipped->neighbors(i)); });
                  };
                },
                circleFamilies()});
}

TEST(GrowthOfQueries, OfCells) {
  expectGrowth({"contains, outline", "cells.h", ofDiagram([](const Diagram& diagram) {
                  forEachCircle(diagram, [&](CircleIndex i) {
                    const Circle& c = diagram.circles[static_cast<std::size_t>(i)];
                    static_cast<void>(contains(diagram, i, {c.x, c.y}));
                    static_cast<void>(outline(diagram, i));
                  });
                }),
                circleFamilies()});
}

TEST(GrowthOfQueries, OfTheClosestPair) {
  expectGrowth({"closestPair", "queries.h",
                ofDiagram([](const Diagram& diagram) { EXPECT_TRUE(closestPair(diagram)); }), circleFamilies()});
}

TEST(GrowthOfQueries, OfMergedVertices) {
  expectGrowth({"mergeVertices", "merged.h",
                ofDiagram([](const Diagram& diagram) { static_cast<void>(mergeVertices(diagram)); }),
                circleFamilies()});
}

TEST(GrowthOfQueries, OfTheHull) {
  expectGrowth({"convexHull", "hull.h",
                ofDiagram([](const Diagram& diagram) { static_cast<void>(convexHull(diagram)); }), circleFamilies()});
}

/// A lattice whose box has all circles inside.
Lattice latticeAround(const std::vector<Circle>& circles) {
  constexpr double kMost = std::numeric_limits<double>::max();
  Box box = {kMost, kMost, -kMost, -kMost};
  for (const Circle& c : circles) {
    box = {std::min(box.minX, c.x), std::min(box.minY, c.y), std::max(box.maxX, c.x), std::max(box.maxY, c.y)};
  }
  return {{1.1 * (box.maxX - box.minX), 0}, {0, 1.1 * (box.maxY - box.minY)}};
}

TEST(GrowthOfQueries, OfAPeriodicDiagram) {
  // In strips of more sites, more vertices of power diagrams need exact numbers: more steps for each, but a bounded
  // number.
  static const std::array kOfPowers = {kUniform, kHub, kComb, kSpiral};
  for (const Metric metric : {Metric::circles, Metric::power}) {
    expectGrowth({"computePeriodic, " + std::string(metricName(metric)), "compute_periodic.h",
                  [metric](const GrowthInput& input) {
                    return [circles = input.circles, metric] {
                      Options options;
                      options.metric = metric;
                      const PeriodicDiagram periodic =
                          computePeriodic(circles, latticeAround(circles), options).value();
                      const PeriodicFinder finder(periodic);
                      for (const Point& p : pointsBetween(circles)) EXPECT_TRUE(finder.find(p));
                      for (CircleIndex i = 0; i < periodic.circleCount; ++i) static_cast<void>(neighbors(periodic, i));
                      static_cast<void>(contactTable(periodic));
                    };
                  },
                  metric == Metric::power ? std::span<const GrowthFamily>(kOfPowers) : circleFamilies()});
  }
}

}  // namespace
}  // namespace circle_voronoi::test
