// SPDX-License-Identifier: GPL-3.0-or-later
// Exact tests of points against determinants of rational numbers.
#include "in_circle.h"

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "report.h"
#include "rounded.h"
#include "tie_inputs.h"

namespace circle_voronoi {
namespace {

using Rational = boost::multiprecision::cpp_rational;

struct RationalPoint {
  Rational x, y;
  explicit RationalPoint(Point p) : x(p.x), y(p.y) {}
};

Rational orientationOf(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The in-circle determinant by its last column, without differences.
Rational inCircleOf(const std::array<Point, 4>& points) {
  Rational sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const RationalPoint p(points[i]);
    const Rational minor = orientationOf(RationalPoint(points[(i + 1) % 4]), RationalPoint(points[(i + 2) % 4]),
                                         RationalPoint(points[(i + 3) % 4]));
    const Rational term = (p.x * p.x + p.y * p.y) * minor;
    sum += i % 2 == 0 ? term : Rational(-term);
  }
  return sum;
}

void compare(std::array<Point, 4> p) {
  for (Point& point : p) point = rounded(point);
  const int side = orientation(p[0], p[1], p[2]);
  ASSERT_EQ(side, orientationOf(RationalPoint(p[0]), RationalPoint(p[1]), RationalPoint(p[2])).sign());
  if (side < 0) std::swap(p[0], p[1]);
  if (side == 0) return;
  EXPECT_EQ(inCircle(p[0], p[1], p[2], p[3]), inCircleOf(p).sign());
}

/// Repeats the comparison for close points.
void compareScaledDown(std::array<Point, 4> points, Random& random) {
  const int exponent = -static_cast<int>(random.below(100));
  for (Point& p : points) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
  compare(points);
}

TEST(InCircle, AgreesWithRationalArithmetic) {
  const std::uint64_t seed = test::seedOr(1);
  for (const test::TieKind& kind : test::tieKinds()) {
    for (int disturbance = 0; disturbance < test::kDisturbances; ++disturbance) {
      const test::Disturbance how{disturbance};
      for (std::uint64_t trial = 0; trial < 50; ++trial) {
        Random random(seed * 1'000'003 + trial);
        auto circles = kind.make(4, random);
        test::disturb(circles, how, random);
        std::array<Point, 4> points;
        for (std::size_t i = 0; i < 4; ++i) points[i] = {circles[i].x, circles[i].y};
        compare(points);
        compareScaledDown(points, random);
        if (testing::Test::HasFailure()) FAIL() << kind.name << ", disturbance " << disturbance << ", trial " << trial;
      }
    }
  }
}

/// One of the doubles next to x, or one after it, or x.
double near(double x, Random& random) {
  for (int steps = static_cast<int>(random.below(5)) - 2; steps != 0; steps += steps < 0 ? 1 : -1) {
    x = std::nextafter(x,
                       steps < 0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity());
  }
  return x;
}

// Numbers of all sizes, from one machine word to the limit of numbers: corners of flat rectangles, and points of very
// different sizes on a line, all moved in their last bits.
TEST(InCircle, AgreesWithRationalArithmeticOverManyBits) {
  Random random(test::seedOr(1));
  const auto number = [&](int exponent) { return std::ldexp(random.uniform(-1, 1), exponent); };
  const auto nearTo = [&](Point p) { return Point{near(p.x, random), near(p.y, random)}; };
  for (int bits = 0; bits < 96; ++bits) {
    for (int trial = 0; trial < 16; ++trial) {
      const int other = static_cast<int>(random.below(static_cast<std::uint64_t>(bits) + 1));
      const double x = number(bits);
      const double y = number(other);
      const std::array<Point, 4> flat = {nearTo({x, y}), nearTo({-x, y}), nearTo({-x, -y}), nearTo({x, -y})};
      compare(flat);
      compareScaledDown(flat, random);
      const Vector along = {random.uniform(-1, 1), random.uniform(-1, 1)};
      const Point far = {std::ldexp(along.x, bits), std::ldexp(along.y, bits)};
      const Point nearer = {std::ldexp(along.x, other), std::ldexp(along.y, other)};
      compare({nearTo({number(0), number(0)}), nearTo(nearer), nearTo(far), {0, 0}});
      if (testing::Test::HasFailure()) FAIL() << bits << " and " << other << " bits";
    }
  }
}

TEST(InCircle, OrientationTakesPointsBetweenTheMultiplesOfTheStep) {
  for (const double tiny : {1e-40, 1e-100, 1e-300, 5e-324}) {
    EXPECT_EQ(orientation({0, 0}, {1, 1}, {tiny, tiny}), 0) << tiny;
    EXPECT_EQ(orientation({0, 0}, {0x1p100, 0x1p100}, {-tiny, -tiny}), 0) << tiny;
    EXPECT_EQ(orientation({0, 0}, {1, 1}, {tiny, 0x1p-90}), 1) << tiny;
  }
}

// Vertices of diagrams whose arrays a program has changed may lie anywhere.
TEST(InCircle, OrientationEndsForPointsOutsideTheRange) {
  constexpr double kHuge = std::numeric_limits<double>::max();
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(orientation({0, 0}, {1e200, 1e200}, {kHuge, kHuge}), 0);
  EXPECT_EQ(orientation({0, 0}, {-kHuge, -kHuge}, {5e-324, 5e-324}), 0);
  for (const double x : {kNaN, kHuge, -kHuge, std::numeric_limits<double>::infinity(), 5e-324}) {
    for (const double y : {kNaN, kHuge, 0x1p-96, 1.0}) {
      const int sign = orientation({x, y}, {0x1p-96, 1}, {y, x});
      EXPECT_TRUE(sign >= -1 && sign <= 1);
    }
  }
}

TEST(InCircle, KnowsTheInside) {
  const Point a = {0, 0}, b = {1, 0}, c = {0, 1};
  EXPECT_EQ(inCircle(a, b, c, {0.5, 0.5}), 1);
  EXPECT_EQ(inCircle(a, b, c, {1, 1}), 0);
  EXPECT_EQ(inCircle(a, b, c, {1, 1 + 0x1p-52}), -1);
  EXPECT_EQ(inCircle(a, b, c, {1, 1 - 0x1p-53}), 1);
  EXPECT_EQ(orientation(a, b, c), 1);
  EXPECT_EQ(orientation(a, c, b), -1);
  EXPECT_EQ(orientation({0, 0}, {1, 1}, {0x1p60, 0x1p60}), 0);
}

}  // namespace
}  // namespace circle_voronoi
