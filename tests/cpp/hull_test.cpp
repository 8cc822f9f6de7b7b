// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "circle_voronoi/compute.h"
#include "circle_voronoi_families/families.h"
#include "fixtures.h"
#include "vectors.h"

namespace circle_voronoi {
namespace {

Hull hullOf(const std::vector<Circle>& circles) { return convexHull(compute(circles).value()); }

struct Measures {
  double length;
  double area;
};

/// From the support function, the farthest that any circle reaches in a direction: its integral over all directions is
/// the length (Cauchy), and the points where it is reached form a polygon of the hull's area.
Measures measuresBySupport(const std::vector<Circle>& circles) {
  constexpr int kDirections = 20000;
  Measures sum = {0, 0};
  std::vector<Point> points;
  for (int k = 0; k < kDirections; ++k) {
    const double angle = 2 * std::numbers::pi * (k + 0.5) / kDirections;
    const Vector u = {std::cos(angle), std::sin(angle)};
    const auto reach = [&](const Circle& c) { return (c.x - circles[0].x) * u.x + (c.y - circles[0].y) * u.y + c.r; };
    const Circle& farthest = *std::ranges::max_element(circles, {}, reach);
    sum.length += reach(farthest) * 2 * std::numbers::pi / kDirections;
    points.push_back({farthest.x - circles[0].x + farthest.r * u.x, farthest.y - circles[0].y + farthest.r * u.y});
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Point& p = points[k];
    const Point& q = points[(k + 1) % points.size()];
    sum.area += cross({p.x, p.y}, {q.x, q.y}) / 2;
  }
  return sum;
}

TEST(Hull, OfOneCircleIsTheCircle) {
  const Hull hull = hullOf({{3, 4, 2}, {3, 4.5, 1}});
  ASSERT_EQ(hull.arcs.size(), 1U);
  EXPECT_DOUBLE_EQ(hull.length, 4 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(hull.area, 4 * std::numbers::pi);
}

TEST(Hull, OfNothingIsEmpty) {
  EXPECT_TRUE(hullOf({}).arcs.empty());
  EXPECT_EQ(hullOf({}).length, 0);
}

TEST(Hull, OfTwoEqualCirclesIsAStadium) {
  const Hull hull = hullOf({{0, 0, 1}, {5, 0, 1}});
  EXPECT_NEAR(hull.length, 10 + 2 * std::numbers::pi, 1e-14);
  EXPECT_NEAR(hull.area, 10 + std::numbers::pi, 1e-14);
}

TEST(Hull, OfPointsIsAPolygon) {
  const Hull hull = hullOf({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, {1, 0.5, 0}});
  EXPECT_EQ(hull.arcs.size(), 4U);
  EXPECT_DOUBLE_EQ(hull.length, 6);
  EXPECT_DOUBLE_EQ(hull.area, 2);
}

TEST(Hull, OfOtherMetricsIsThatOfTheCenters) {
  for (const Metric metric : {Metric::centers, Metric::power}) {
    const Hull hull =
        convexHull(compute(std::vector<Circle>{{0, 0, 1}, {3, 0, 1.5}, {0, 4, 1}}, {.metric = metric}).value());
    EXPECT_DOUBLE_EQ(hull.length, 12);
    EXPECT_DOUBLE_EQ(hull.area, 6);
  }
}

TEST(Hull, OfCollinearPointsGoesThereAndBack) {
  const Hull hull = hullOf({{0, 0, 0}, {2, 0, 0}, {5, 0, 0}});
  EXPECT_DOUBLE_EQ(hull.length, 10);
  EXPECT_EQ(hull.area, 0);
}

TEST(Hull, ACircleMayRecur) {
  const Hull hull = hullOf({{0, 0, 10}, {10.5, 0, 0.1}, {0, 10.5, 0.1}, {-10.5, 0, 0.1}});
  EXPECT_EQ(std::ranges::count(hull.arcs, 0, &HullArc::circle), 3);
}

TEST(Hull, TurnsAroundTheLargerOfTwoCirclesThatNearlyTouchInside) {
  const auto circles = test::readFixture("hull-around-the-larger-nested-tangent-2");
  const Hull hull = hullOf(circles);
  ASSERT_EQ(hull.arcs.size(), 2U);
  EXPECT_EQ(circles[1].r, std::max(circles[0].r, circles[1].r));
  for (const HullArc& arc : hull.arcs) EXPECT_NEAR(arc.angle, arc.circle == 1 ? 2 * std::numbers::pi : 0, 1e-6);
  EXPECT_NEAR(hull.length, 2 * std::numbers::pi * circles[1].r, 1e-6);
  EXPECT_NEAR(hull.area, std::numbers::pi * circles[1].r * circles[1].r, 1e-6);
}

TEST(Hull, TurnsOnceThoughACircleBarelyReachesOut) {
  // The second reaches out of the first by rounding, between whose arcs there is next to no angle, or less.
  constexpr double kTiny = 2.6752892779233195e-25;
  const Hull hull = hullOf({{1.9547866739766219e28, 1.9547867389497822e28, 1.9547867389497822e28},
                            {1.9547867389497822e28, 2.6752892779233242e-25, kTiny},
                            {kTiny, kTiny, kTiny}});
  double turn = 0;
  for (const HullArc& arc : hull.arcs) turn += arc.angle;
  EXPECT_NEAR(turn, 2 * std::numbers::pi, 1e-14);
}

TEST(Hull, HasTheLengthAndAreaOfTheSupportFunction) {
  for (const FamilyInfo& family : families()) {
    for (const std::size_t count : {2U, 3U, 10U, 60U}) {
      SCOPED_TRACE(std::string(family.name) + " " + std::to_string(count));
      const auto circles = generate(family.family, count, count);
      const Hull hull = hullOf(circles);
      const auto [length, area] = measuresBySupport(circles);
      double turn = 0;
      for (const HullArc& arc : hull.arcs) {
        EXPECT_GE(arc.angle, 0);
        turn += arc.angle;
      }
      EXPECT_NEAR(turn, 2 * std::numbers::pi, 1e-12);
      EXPECT_NEAR(hull.length, length, 1e-6 * length);
      EXPECT_NEAR(hull.area, area, 1e-6 * length * length);
    }
  }
}

}  // namespace
}  // namespace circle_voronoi
