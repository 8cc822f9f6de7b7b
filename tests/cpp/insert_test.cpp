// SPDX-License-Identifier: GPL-3.0-or-later
#include "insert.h"

#include <gtest/gtest.h>

#include "circle_voronoi/compute.h"
#include "circle_voronoi_families/families.h"
#include "face_discs.h"
#include "flip.h"
#include "found_sites.h"
#include "insert_cell.h"
#include "judge.h"
#include "random.h"
#include "report.h"
#include "tie_inputs.h"
#include "validate.h"

namespace circle_voronoi {
namespace {

std::vector<Circle> visibleCircles(const std::vector<Circle>& circles) {
  return test::foundSites(order(validate(circles).value())).sites.circles;
}

/// Whether insertion, and the flips that follow it, lead to the right dual.
bool isInsertedRightly(const std::vector<Circle>& circles) {
  Predicates predicates(circles);
  auto inserted = insertAll(circles, predicates);
  if (!inserted) return false;
  FaceDiscs discs(circles, inserted->dual, predicates);
  flip(inserted->dual, discs);
  return judge(circles, inserted->dual, predicates).isRight();
}

TEST(Insert, IsRightInGeneralPosition) {
  const std::uint64_t seed = test::seedOr(1);
  for (const FamilyInfo& family : families()) {
    if (family.isDegenerate) continue;
    for (const std::size_t count : {0, 1, 2, 3, 4, 5, 10, 30, 100, 1000}) {
      const auto circles = visibleCircles(generate(family.family, count, seed));
      EXPECT_TRUE(isInsertedRightly(circles)) << family.name << ", " << count << ", seed " << seed;
    }
  }
}

TEST(Insert, IsRightInTies) {
  const std::uint64_t seed = test::seedOr(1);
  const auto attempt = [&](const std::vector<Circle>& circles, std::string_view name) {
    EXPECT_TRUE(isInsertedRightly(visibleCircles(circles))) << name << ", seed " << seed;
  };
  for (const FamilyInfo& family : families()) {
    if (!family.isDegenerate) continue;
    for (const std::size_t count : {3, 10, 30, 100, 300}) attempt(generate(family.family, count, seed), family.name);
  }
  test::forEachTie(seed, 30, attempt);
}

/// Circles tangent to the circle of radius 1 around the origin from inside: each is all but hidden by those before it.
std::vector<Circle> tangentInside(std::size_t count) {
  Random random(1);
  std::vector<Circle> circles(count);
  for (Circle& c : circles) {
    const double distance = random.unit();
    const Vector direction = random.direction();
    c = {distance * direction.x, distance * direction.y, 1 - distance};
  }
  return circles;
}

TEST(Insert, TakesAFewFlipsACircleWhereFlipsFromTheCentersFindNoWay) {
  const auto circles = visibleCircles(tangentInside(2000));
  Predicates predicates(circles);
  const auto inserted = insertAll(circles, predicates);
  ASSERT_TRUE(inserted);
  EXPECT_TRUE(judge(circles, inserted->dual, predicates).isRight());
  EXPECT_LT(inserted->flips, 5 * 2000);
}

/// A few circles at each power of two: from the center of one, all larger ones look equally far away.
std::vector<Circle> atPowersOfTwo(std::size_t count, Random& random) {
  std::vector<Circle> circles(count);
  for (Circle& c : circles) {
    const double size = std::ldexp(1.0, -static_cast<int>(random.below(900)));
    const Vector direction = random.direction();
    c = {size * direction.x, size * direction.y, 0.2 * size};
  }
  return circles;
}

TEST(Insert, FindsTheEdgeThatACellCutsWhereDistancesLookEqual) {
  const std::uint64_t seed = test::seedOr(1);
  Random random(seed);
  for (int trial = 0; trial < 20; ++trial) {
    EXPECT_TRUE(isInsertedRightly(visibleCircles(atPowersOfTwo(200, random)))) << "seed " << seed;
  }
}

/// Expects insertion to be right in 50 random orders of a few circles, which include most orders.
void expectRightInAnyOrder(std::vector<Circle> circles) {
  const std::uint64_t seed = test::seedOr(1);
  Random random(seed);
  for (int trial = 0; trial < 50; ++trial) {
    for (std::size_t i = circles.size(); i > 1; --i) std::swap(circles[i - 1], circles[random.below(i)]);
    EXPECT_TRUE(isInsertedRightly(circles)) << "seed " << seed << ", trial " << trial;
  }
}

TEST(Insert, PutsACircleBetweenTwoThatItTouchesInOnePoint) {
  // All three touch both common tangent lines. The point lies outside the first circle by less than rounding shows.
  const Circle outer = {0, 0, 0x1.247fbc97ed6ccp+4};
  const Circle point = {0x1.a79e83e4dc454p+3, 0x1.9372653b7c72bp+3, 0};
  const Circle middle = {point.x / 2, point.y / 2, outer.r / 2};
  expectRightInAnyOrder(visibleCircles({outer, point, middle}));
}

TEST(Insert, TakesAwayAllOfAHullEdgeWhoseTangentLineACircleTouchesFromOutside) {
  // At first the two points share a tangent line of the hull. The circle above the axis touches that line from outside,
  // so afterwards the point beside it has the opposite line.
  expectRightInAnyOrder(visibleCircles({{-1, 0, 0}, {-0x1p-15, 0, 0}, {-0x1p-39, 1, 1}, {1.5, -2, 2}}));
}

TEST(Insert, TheLeadOfANearerCircleIsRightWhereDistancesLookEqual) {
  // Seen from 1, both are at distance 1 to all digits of a double.
  const Circle farther = {-1e-30, 0, 1e-31};
  const Circle nearer = {2e-30, 0, 1e-31};
  EXPECT_NEAR(leadOf({1, 0}, farther, nearer).value, 3e-30, 1e-44);
  EXPECT_EQ(leadOf({1, 0}, farther, nearer).sign(), 1);
  EXPECT_EQ(leadOf({1, 0}, nearer, farther).sign(), -1);
  EXPECT_EQ(leadOf({1, 0}, nearer, nearer).sign(), 0);
}

TEST(Insert, IsTheWayWhereCirclesAllButHideOneAnother) {
  const auto diagram = compute(tangentInside(2000));
  ASSERT_TRUE(diagram);
  EXPECT_TRUE(diagram.value().certificate.certified());
  EXPECT_EQ(diagram.value().stats.way, Way::insert);
}

}  // namespace
}  // namespace circle_voronoi
