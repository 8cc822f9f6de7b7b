// SPDX-License-Identifier: GPL-3.0-or-later
// Where a vertex is, however nearly its circles have no disc, or an infinitely large one.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "circle_voronoi/certify.h"
#include "circle_voronoi/compute.h"
#include "exact.h"
#include "found_sites.h"
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
        const Vertex right = exact::disc(face).value();
        const Vertex vertex = vertexOf(a, b, c).value();
        const double reach = length(between(a, b)) + length(between(b, c)) + std::hypot(right.x - a.x, right.y - a.y);
        // Less than the 36 bits promised, because coordinates are rounded.
        const double size = std::abs(a.x) + std::abs(a.y) + a.r;
        const double error = 0x1p-34 * reach + 0x1p-50 * size;
        EXPECT_LE(std::abs(vertex.x - right.x), error);
        EXPECT_LE(std::abs(vertex.y - right.y), error);
        EXPECT_LE(std::abs(vertex.r - right.r), error);
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
        compareAll(test::foundSites(order(validate(circles).value())).sites.circles);
        if (testing::Test::HasFailure())
          FAIL() << kind.name << ", disturbance " << disturbance << test::describe(circles);
      }
    }
  }
}

TEST(Vertex, HasTheSameBitsAtEveryScale) {
  const std::uint64_t seed = test::seedOr(1);
  for (std::uint64_t trial = 0; trial < 300; ++trial) {
    Random random(seed * 1'000'003 + trial);
    std::array<Circle, 3> circles;
    for (Circle& c : circles) c = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0, 0.3)};
    const auto vertex = vertexOf(circles[0], circles[1], circles[2]);
    for (const int scaling : {95, 60, 20, -10, -20, -40}) {
      const auto scaled = [&](double x) { return std::ldexp(x, scaling); };
      std::array<Circle, 3> moved = circles;
      for (Circle& c : moved) c = {scaled(c.x), scaled(c.y), scaled(c.r)};
      const auto found = vertexOf(moved[0], moved[1], moved[2]);
      ASSERT_EQ(found.has_value(), vertex.has_value());
      if (!vertex) continue;
      EXPECT_EQ(*found, (Vertex{scaled(vertex->x), scaled(vertex->y), scaled(vertex->r)}))
          << "trial " << trial << ", times 2^" << scaling << test::describe(circles);
    }
  }
}

TEST(Vertex, OfEqualCirclesThatRoundingTookOffALineIsFarAwayAndCertified) {
  // Equal circles on a line in decimals: the small bend by rounding puts a vertex far away.
  const std::vector<Circle> circles = {{0.1, 0.3, 0.05}, {0.2, 0.6, 0.05}, {0.7, 2.1, 0.05}};
  const Diagram diagram = compute(circles).value();
  ASSERT_EQ(diagram.vertices.size(), 1U);
  EXPECT_GT(diagram.vertices[0].r, 1e14);
  EXPECT_TRUE(certify(diagram).value().certified());
}

/// Three points that bend by `bend` from a line, of a given size: their disc has its center at (size / 2, size / bend).
std::vector<Circle> bent(double size, double bend) { return {{0, 0, 0}, {size, 0, 0}, {2 * size, size * bend, 0}}; }

TEST(Vertex, FarAwayIsRightAndCertified) {
  for (const double size : {0x1p-50, 0x1p-26, 1.0, 0x1p40, 0x1p94}) {
    for (const double bend : {1e-9, 1e-11, 1e-20, 1e-28, 1e-40, 2e-57}) {
      std::vector<Circle> circles = bent(size, bend);
      circles[2].y = rounded(circles[2].y);
      const double y = size / (circles[2].y / size);
      if (!std::isfinite(y)) continue;
      Diagram diagram = compute(circles).value();
      ASSERT_EQ(diagram.vertices.size(), 1U) << size << ", " << bend;
      Vertex& v = diagram.vertices[0];
      EXPECT_NEAR(v.y / y, 1, 1e-14) << size << ", " << bend;
      EXPECT_NEAR(v.r / y, 1, 1e-14) << size << ", " << bend;
      EXPECT_NEAR(v.x / (y + size), size / 2 / (y + size), 1e-14) << size << ", " << bend;
      EXPECT_TRUE(certify(diagram).value().certified()) << size << ", " << bend;
      // Rounded by another program, and wrong.
      v.y = std::nextafter(v.y, 0);
      EXPECT_TRUE(certify(diagram).value().certified()) << size << ", " << bend;
      v.y /= 2;
      EXPECT_EQ(certify(diagram).value().flaw, Flaw::vertexMisplaced) << size << ", " << bend;
      v.r /= 2;
      EXPECT_EQ(certify(diagram).value().flaw, Flaw::vertexMisplaced) << size << ", " << bend;
    }
  }
}

TEST(Vertex, TheFarthestThatNumbersMakeIsRightAndCertified) {
  // The smallest area that three points at the limit can span.
  const double step = kCoordinateStep;
  const double limit = kCoordinateLimit;
  Diagram diagram = compute(std::vector<Circle>{{-limit, 0, 0}, {limit, 0, 0}, {0, -step, 0}}).value();
  ASSERT_EQ(diagram.vertices.size(), 1U);
  EXPECT_NEAR(diagram.vertices[0].r / (limit * limit / (2 * step)), 1, 1e-10);
  EXPECT_TRUE(certify(diagram).value().certified());
  // The largest numbers are certified no more than others.
  diagram.vertices[0] = {0, std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  EXPECT_EQ(certify(diagram).value().flaw, Flaw::vertexMisplaced);
  // Circles that nearly touch one line: their disc is as far as the square of the limit, and more.
  const Diagram touching =
      compute(std::vector<Circle>{{-limit, limit / 2, limit / 2}, {limit, limit / 4, limit / 4}, {0, step, 0}}).value();
  EXPECT_TRUE(certify(touching).value().certified());
  for (const Vertex& v : touching.vertices) EXPECT_TRUE(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.r));
}

TEST(Vertex, OfTheSmallestCirclesIsCertified) {
  for (const double unit : {0x1p-62, 0x1p-80, 0x1p-96}) {
    const std::vector<Circle> circles = {
        {0, 0, 7 * unit}, {90 * unit, 8 * unit, 3 * unit}, {31 * unit, 77 * unit, 5 * unit}, {1, 0, 0}};
    const Diagram diagram = compute(circles).value();
    EXPECT_TRUE(certify(diagram).value().certified()) << unit;
  }
}

}  // namespace
}  // namespace circle_voronoi
