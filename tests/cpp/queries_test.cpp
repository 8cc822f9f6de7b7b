// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/queries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "circle_voronoi/compute.h"
#include "circle_voronoi/hull.h"
#include "circle_voronoi_families/families.h"
#include "far_apart.h"
#include "parameters.h"
#include "path_checks.h"
#include "random.h"
#include "regions.h"
#include "rounded.h"
#include "vectors.h"

namespace circle_voronoi {
namespace {

double clearance(const std::vector<Circle>& circles, Point p) { return test::clearanceAlong(circles, p, p); }

/// Whether a disc with its center at p and radius 0 lies inside the hull: seen from everywhere some circle reaches as
/// far.
double depthInHull(const std::vector<Circle>& circles, Point p) {
  double depth = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3000; ++k) {
    const double angle = 2 * std::numbers::pi * k / 3000;
    const Vector u = {std::cos(angle), std::sin(angle)};
    double reach = -std::numeric_limits<double>::infinity();
    for (const Circle& c : circles) reach = std::max(reach, (c.x - p.x) * u.x + (c.y - p.y) * u.y + c.r);
    depth = std::min(depth, reach);
  }
  return depth;
}

class Queries : public testing::TestWithParam<Family> {};

TEST_P(Queries, ClosestPairHasTheSmallestGap) {
  for (const std::size_t count : {2U, 3U, 10U, 80U}) {
    SCOPED_TRACE(count);
    const auto circles = generate(GetParam(), count, count);
    const Diagram diagram = compute(circles).value();
    std::vector<bool> isHidden(circles.size(), false);
    for (const HiddenCircle& hidden : diagram.hidden) isHidden[static_cast<std::size_t>(hidden.circle)] = true;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < circles.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (isHidden[i] || isHidden[j]) continue;
        least = std::min(least, length(between(circles[i], circles[j])) - circles[i].r - circles[j].r);
      }
    }
    const auto closest = closestPair(diagram);
    ASSERT_EQ(closest.has_value(), std::isfinite(least));
    if (!closest) continue;
    const Circle& c = circles[static_cast<std::size_t>(closest->first)];
    EXPECT_NEAR(closest->gap, least, 1e-14 * (std::abs(c.x) + std::abs(c.y) + c.r + std::abs(least)));
  }
}

TEST_P(Queries, NoSampledDiscIsLarger) {
  Random random(1);
  for (const std::size_t count : {1U, 2U, 3U, 4U, 10U, 60U}) {
    SCOPED_TRACE(count);
    const auto circles = generate(GetParam(), count, count);
    const Diagram diagram = compute(circles).value();
    const Box whole = test::validBoxOf(circles);
    const double size = std::max(whole.maxX - whole.minX, whole.maxY - whole.minY);
    const double rounding = 1e-12 * (size + std::abs(whole.minX) + std::abs(whole.minY));

    for (int trial = 0; trial < 5; ++trial) {
      const Point p = {random.uniform(whole.minX, whole.maxX), random.uniform(whole.minY, whole.maxY)};
      const double width = size * random.logUniform(-2, 0.3);
      const Box box = {rounded(p.x - width), rounded(p.y - width / 2), rounded(p.x + width), rounded(p.y + width / 2)};
      const auto largest = largestEmptyDiscCenteredIn(diagram, test::regionOf(box));
      ASSERT_TRUE(largest);
      const Vertex& disc = largest->disc;
      EXPECT_TRUE(disc.x >= box.minX && disc.x <= box.maxX && disc.y >= box.minY && disc.y <= box.maxY);
      EXPECT_NEAR(clearance(circles, {disc.x, disc.y}), disc.r, rounding);
      double best = -std::numeric_limits<double>::infinity();
      for (int k = 0; k < 2000; ++k) {
        best = std::max(best,
                        clearance(circles, {random.uniform(box.minX, box.maxX), random.uniform(box.minY, box.maxY)}));
      }
      EXPECT_LE(best, disc.r + rounding);
      EXPECT_GE(best, disc.r - width / 5);
    }

    const auto inHull = largestEmptyDiscCenteredInHull(diagram);
    ASSERT_TRUE(inHull);
    const Vertex& disc = inHull->disc;
    EXPECT_GE(disc.r, 0);
    EXPECT_NEAR(clearance(circles, {disc.x, disc.y}), disc.r, rounding);
    EXPECT_GE(depthInHull(circles, {disc.x, disc.y}), -rounding);
    for (int k = 0; k < 1000; ++k) {
      const Point p = {random.uniform(whole.minX, whole.maxX), random.uniform(whole.minY, whole.maxY)};
      if (clearance(circles, p) <= disc.r + rounding) continue;
      // The directions sampled may miss that p is outside by a little.
      EXPECT_LE(depthInHull(circles, p), 1e-3 * size) << p.x << ' ' << p.y;
    }
  }
}

/// The distance of a point from the nearest side of a convex region, negative outside.
double depthIn(const Region& region, Point p) {
  double depth = std::numeric_limits<double>::infinity();
  const auto corners = region.points();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Point from = corners[k];
    const Point to = corners[(k + 1) % corners.size()];
    const Vector side = {to.x - from.x, to.y - from.y};
    depth = std::min(depth, cross(side, {p.x - from.x, p.y - from.y}) / length(side));
  }
  return depth;
}

TEST_P(Queries, NoSampledDiscInsideARegionIsLarger) {
  Random random(2);
  for (const std::size_t count : {1U, 2U, 3U, 4U, 10U, 60U}) {
    SCOPED_TRACE(count);
    const auto circles = generate(GetParam(), count, count);
    const Diagram diagram = compute(circles).value();
    const Box whole = test::validBoxOf(circles);
    const double size = std::max(whole.maxX - whole.minX, whole.maxY - whole.minY);
    for (int trial = 0; trial < 6; ++trial) {
      SCOPED_TRACE(trial);
      const Point p = {random.uniform(whole.minX, whole.maxX), random.uniform(whole.minY, whole.maxY)};
      const double width = size * random.logUniform(-2, 0.3);
      Region region = test::regionOf(Box{p.x - width, p.y - width / 2, p.x + width, p.y + width / 2});
      if (trial % 2 == 1) {
        std::vector<Point> corners;
        const std::size_t cornerCount = 3 + random.below(8);
        const double turn = random.unit();
        for (std::size_t k = 0; k < cornerCount; ++k) {
          const Vector direction = directionAt((static_cast<double>(k) + turn) / static_cast<double>(cornerCount));
          corners.push_back({p.x + width * direction.x, p.y + width * direction.y});
        }
        region = test::regionOf(corners);
      }
      const double rounding = 1e-12 * (size + width + std::abs(p.x) + std::abs(p.y));
      const auto largest = largestEmptyDiscInside(diagram, region).value();
      ASSERT_TRUE(largest);
      const Point center = {largest->disc.x, largest->disc.y};
      const double radius = largest->disc.r;
      const auto room = [&](Point q) { return std::min(depthIn(region, q), clearance(circles, q)); };
      // Rounding cannot make the result larger than the true one.
      EXPECT_NEAR(room(center), radius, rounding);
      for (const std::int32_t circle : largest->circles) {
        if (circle == kNone) continue;
        EXPECT_NEAR(distance(Metric::circles, circles[static_cast<std::size_t>(circle)], center), radius,
                    1e-9 * (size + width) + rounding);
      }
      // No larger disc exists: try many points, and climb from the best one.
      Point best = center;
      for (int k = 0; k < 1000; ++k) {
        const Point q = {p.x + width * random.uniform(-1, 1), p.y + width * random.uniform(-1, 1)};
        if (room(q) > room(best) || (k == 0 && depthIn(region, q) > 0)) best = q;
      }
      for (double step = width / 10; step > 1e-9 * width; step *= 0.9) {
        const Vector direction = directionAt(random.unit());
        const Point q = {best.x + step * direction.x, best.y + step * direction.y};
        if (room(q) > room(best)) best = q;
      }
      if (depthIn(region, best) > 0) {
        EXPECT_LE(room(best), radius + rounding);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Families, Queries,
                         testing::ValuesIn(test::familiesWhere([](Family f) { return !test::isTooWideToDraw(f); })),
                         test::NameOfParameter());

TEST(Queries, NoCirclesHaveNoAnswers) {
  const Diagram diagram = compute({}).value();
  EXPECT_FALSE(closestPair(diagram));
  EXPECT_FALSE(largestEmptyDiscCenteredIn(diagram, test::regionOf(Box{0, 0, 1, 1})));
  EXPECT_FALSE(largestEmptyDiscCenteredInHull(diagram));
  // But a region has a largest disc.
  const auto inside = largestEmptyDiscInside(diagram, test::regionOf(Box{0, 0, 1, 1})).value();
  ASSERT_TRUE(inside);
  EXPECT_EQ(inside->disc.r, 0.5);
}

TEST(Queries, NeighborPairsAreThoseOfTheEdges) {
  const auto circles = generate(Family::oneHuge, 100, 3);
  const Diagram diagram = compute(circles).value();
  std::set<std::array<CircleIndex, 2>> expected;
  for (const Edge& edge : diagram.edges) {
    expected.insert({std::min(edge.left, edge.right), std::max(edge.left, edge.right)});
  }
  ASSERT_LT(expected.size(), diagram.edges.size());  // some share several
  const auto pairs = neighborPairs(diagram);
  EXPECT_TRUE(std::ranges::equal(pairs, expected));
  EXPECT_TRUE(neighborPairs({}).empty());
}

TEST(Queries, TheLargestEmptyDiscMayTouchTwoCirclesFromTheEdgeOfTheHull) {
  const std::vector<Circle> circles = {{0, 0, 1}, {10, 0, 1}};
  const Diagram diagram = compute(circles).value();
  const auto largest = largestEmptyDiscCenteredInHull(diagram);
  ASSERT_TRUE(largest);
  EXPECT_NEAR(largest->disc.x, 5, 1e-14);
  EXPECT_NEAR(std::abs(largest->disc.y), 1, 1e-14);
  EXPECT_NEAR(largest->disc.r, std::sqrt(26) - 1, 1e-14);
}

// The hull of a weight below zero is grown until its circle is a point.
TEST(Queries, TheLargestEmptyDiscInTheHullOfOneCircleTouchesItsRim) {
  for (const double r : {2.0, 0.0, -3.0}) {
    const std::vector<Circle> circles = {{5, 6, r - 1}, {5, 6, r}};
    Options options;
    options.weights = true;
    const Diagram diagram = compute(circles, options).value();
    const auto largest = largestEmptyDiscCenteredInHull(diagram);
    ASSERT_TRUE(largest);
    EXPECT_EQ(largest->disc.r, std::max(-r, 0.0));
    EXPECT_EQ(largest->circles, (std::array<CircleIndex, 3>{1, kNone, kNone}));
    const double x = largest->disc.x - 5, y = largest->disc.y - 6;
    EXPECT_NEAR(std::sqrt(x * x + y * y), std::max(r, 0.0), 1e-15);
  }
}

TEST(Queries, TheLargestEmptyDiscInsideTouchesThreeCirclesOrSides) {
  struct Case {
    std::vector<Circle> circles;
    Box box;
    double r;
  };
  const double y = 5 * std::sqrt(3);
  for (const auto& [circles, box, radius] :
       {Case{{{10, 0, 1}, {-5, y, 1}, {-5, -y, 1}}, {-9.5, -9.25, 9.75, 9.5}, 9},
        Case{{{-3, 0, 1}, {3, 0, 1}}, {-3, -4, 3, 4}, 2.4},
        Case{{{0, 0, 1}}, {0, 0, 4, 4}, (4 * std::sqrt(2) - 1) / (1 + std::sqrt(2))},
        Case{{{-0.5, 0, 0.6}, {8.5, 0, 0.6}}, {-1, -1, 9, 1}, 1}, Case{{{50, 0, 1}}, {0, 0, 4, 3}, 1.5},
        // An edge passes through the center, but neither of its circles touches.
        Case{{{4, 0, 0}, {4, 1, 0}}, {3.9, 0, 4.1, 1}, 0.1}}) {
    const Diagram diagram = compute(circles).value();
    const auto largest = largestEmptyDiscInside(diagram, test::regionOf(box)).value();
    ASSERT_TRUE(largest);
    EXPECT_NEAR(largest->disc.r, radius, 1e-14);
    // Any of several equal discs may be found. It names the circles that it touches, and no other.
    for (CircleIndex i = 0; i < static_cast<std::int32_t>(circles.size()); ++i) {
      const double distance = distanceFrom(diagram, i, {largest->disc.x, largest->disc.y});
      EXPECT_GE(distance, radius - 1e-14);
      EXPECT_EQ(std::ranges::count(largest->circles, i), distance < radius + 1e-13 ? 1 : 0) << "circle " << i;
    }
  }
}

TEST(Queries, WhereCirclesCoverTheRegionNoDiscIsInside) {
  const std::vector<Circle> circles = {{0, 0, 10}, {12, 0, 5}};
  const Diagram diagram = compute(circles).value();
  const Box covered = {-1, -2, 3, 2};
  EXPECT_LT(largestEmptyDiscInside(diagram, test::regionOf(covered)).value()->disc.r, 0);
  EXPECT_EQ(largestEmptyDiscInside(diagram, test::regionOf(covered)).value()->disc,
            largestEmptyDiscCenteredIn(diagram, test::regionOf(covered))->disc);
}

}  // namespace
}  // namespace circle_voronoi
