// SPDX-License-Identifier: GPL-3.0-or-later
// Where a vertex is, however nearly its circles have no disc, or an infinitely large one.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "circle_voronoi/compute.h"
#include "exact.h"
#include "hide.h"
#include "report.h"
#include "three_touch_disc.h"
#include "tie_inputs.h"
#include "validate.h"

namespace circle_voronoi {
namespace {

void compareAll(const std::vector<Circle>& circles) {
  for (const Circle& a : circles) {
    for (const Circle& b : circles) {
      for (const Circle& c : circles) {
        const exact::Face face = {&a, &b, &c};
        if (&a == &b || &b == &c || &c == &a || !exact::hasDisc(face)) continue;
        const Vertex right = exact::disc(face);
        const Vertex vertex = vertexOf(a, b, c);
        const double reach = length(between(a, b)) + length(between(b, c)) + std::hypot(right.x - a.x, right.y - a.y);
        // Less than the 36 bits promised, for what the coordinates themselves are rounded to.
        const double size = std::abs(a.x) + std::abs(a.y) + a.r;
        const double error = 0x1p-34 * reach + 0x1p-50 * size;
        EXPECT_LE(std::abs(vertex.x - right.x), error);
        EXPECT_LE(std::abs(vertex.y - right.y), error);
        EXPECT_LE(std::abs(vertex.radius - right.radius), error);
      }
    }
  }
}

TEST(Vertex, IsThatOfExactArithmeticInAndNearTies) {
  const std::uint64_t seed = test::seedOr(1);
  for (const test::TieKind& kind : test::tieKinds()) {
    for (int disturbance = 0; disturbance < test::kDisturbances; ++disturbance) {
      for (std::uint64_t trial = 0; trial < 20; ++trial) {
        Random random(seed * 1'000'003 + trial * 64 + static_cast<std::uint64_t>(disturbance));
        auto circles = kind.make(5, random);
        test::disturb(circles, test::Disturbance{disturbance}, random);
        compareAll(hide(order(validate(circles).value().circles)).circles);
        if (testing::Test::HasFailure())
          FAIL() << kind.name << ", disturbance " << disturbance << test::describe(circles);
      }
    }
  }
}

TEST(Vertex, OfCirclesThatRoundingTookOffALine) {
  // Equal circles on a line in decimals: what is left of the bend puts a vertex far away.
  const std::vector<Circle> circles = {{0.1, 0.3, 0.05}, {0.2, 0.6, 0.05}, {0.7, 2.1, 0.05}};
  const Diagram diagram = compute(circles).value();
  ASSERT_EQ(diagram.vertices.size(), 1U);
  EXPECT_GT(diagram.vertices[0].radius, 1e14);
  EXPECT_TRUE(certify(circles, diagram).value().certified());
}

TEST(Vertex, BeyondTheRangeOfDoublesKeepsItsDirection) {
  const std::vector<Circle> circles = {{0, 0, 0}, {1e150, 0, 0}, {-1e150, 1e-100, 0}};
  const Diagram diagram = compute(circles).value();
  ASSERT_EQ(diagram.vertices.size(), 1U);
  const Vertex& v = diagram.vertices[0];
  EXPECT_TRUE(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.radius));
  EXPECT_GT(v.y, 1e200);
  EXPECT_TRUE(certify(circles, diagram).value().certified());
}

TEST(Vertex, OfTheSmallestDoubles) {
  for (const double unit : {0x1p-1074, 0x1p-1070, 0x1p-1022, 0x1p-1000}) {
    const std::vector<Circle> circles = {
        {0, 0, 7 * unit}, {90 * unit, 8 * unit, 3 * unit}, {31 * unit, 77 * unit, 5 * unit}};
    const Diagram diagram = compute(circles).value();
    EXPECT_TRUE(certify(circles, diagram).value().certified()) << unit;
  }
}

}  // namespace
}  // namespace circle_voronoi
