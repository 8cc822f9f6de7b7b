// SPDX-License-Identifier: GPL-3.0-or-later
#include "three_touch_disc.h"

#include <gtest/gtest.h>

#include <cmath>

#include "circle_voronoi_families/families.h"

namespace circle_voronoi {
namespace {

/// The distance of a disc from touching a circle from outside.
double gap(const Vertex& disc, const Circle& c) { return length({disc.x - c.x, disc.y - c.y}) - c.r - disc.r; }

TEST(ThreeTouchDisc, OfEqualCirclesIsCenteredInTheCircumcenter) {
  const auto disc = threeTouchDisc({0, 0, 1}, {6, 0, 1}, {0, 8, 1});
  ASSERT_TRUE(disc);
  EXPECT_DOUBLE_EQ(disc->disc.x, 3);
  EXPECT_DOUBLE_EQ(disc->disc.y, 4);
  EXPECT_DOUBLE_EQ(disc->disc.r, 4);
}

TEST(ThreeTouchDisc, IsThatOfTheOrientationGiven) {
  EXPECT_FALSE(threeTouchDisc({0, 0, 1}, {0, 8, 1}, {6, 0, 1})) << "clockwise, equal circles have none";
  // A small circle in the middle of two large ones has a disc on either side.
  const Circle left = {-5, 0, 4};
  const Circle right = {5, 0, 4};
  const Circle middle = {0, 0, 0.1};
  const auto above = threeTouchDisc(left, middle, right);
  const auto below = threeTouchDisc(right, middle, left);
  ASSERT_TRUE(above && below);
  EXPECT_GT(above->disc.y, 0);
  EXPECT_DOUBLE_EQ(below->disc.y, -above->disc.y);
}

TEST(ThreeTouchDisc, HasANegativeRadiusInsideIntersectingCircles) {
  const auto disc = threeTouchDisc({-1, 0, 2}, {1, 0, 2}, {0, 1.5, 2});
  ASSERT_TRUE(disc);
  EXPECT_LT(disc->disc.r, 0);
  EXPECT_NEAR(gap(disc->disc, {-1, 0, 2}), 0, 1e-14);
}

// The other disc of three circles that rest on one line is the line itself, and one form of the root 0 / 0.
TEST(ThreeTouchDisc, OfCirclesOnALineIsExact) {
  const auto disc = threeTouchDisc({-3, 2, 2}, {0, 0.5, 0.5}, {3, 2, 2});
  ASSERT_TRUE(disc);
  EXPECT_EQ(disc->disc, (Vertex{0, 2, 1}));
}

// Nearly on a line that form cancels.
TEST(ThreeTouchDisc, OfCirclesNearlyOnALineDoesNotCancel) {
  for (const double off : {1e-9, -1e-9, 1e-12, -1e-12}) {
    const Circle left = {-3, 2, 2};
    const Circle right = {3, 2, 2};
    const Circle middle = {0, 0.5 + off, 0.5};
    const auto disc = threeTouchDisc(left, middle, right);
    ASSERT_TRUE(disc);
    for (const Circle& c : {left, middle, right}) EXPECT_NEAR(gap(disc->disc, c), 0, 1e-14) << off;
  }
}

TEST(ThreeTouchDisc, TouchesRandomCircles) {
  for (const Family family : {Family::uniform, Family::logUniform, Family::mixed, Family::lightlyIntersecting}) {
    int found = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      const auto circles = generate(family, 3, seed);
      const auto disc = threeTouchDisc(circles[0], circles[1], circles[2]);
      if (!disc) continue;
      ++found;
      const double scale = 10 + disc->disc.r;
      for (const Circle& c : circles) EXPECT_NEAR(gap(disc->disc, c), 0, 1e-11 * scale * scale);
    }
    EXPECT_GT(found, 90) << familyName(family);
  }
}

TEST(ThreeTouchDisc, IsTheSameForEachRotationOfTheTriple) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto c = generate(Family::logUniform, 3, seed);
    const auto abc = threeTouchDisc(c[0], c[1], c[2]);
    const auto bca = threeTouchDisc(c[1], c[2], c[0]);
    ASSERT_EQ(abc.has_value(), bca.has_value());
    if (abc) {
      EXPECT_EQ(abc->disc, bca->disc);
    }
  }
}

TEST(ThreeTouchDisc, DoesNotChangeWithANumberAddedToAllRadii) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    auto c = generate(Family::uniform, 3, seed);
    // Multiples of 2^-20 make the sums exact.
    for (Circle& circle : c) circle.r = std::floor(circle.r * 0x1p20) * 0x1p-20;
    const auto before = threeTouchDisc(c[0], c[1], c[2]);
    for (Circle& circle : c) circle.r += 8;
    const auto after = threeTouchDisc(c[0], c[1], c[2]);
    ASSERT_EQ(before.has_value(), after.has_value());
    if (before) {
      EXPECT_EQ(before->disc.x, after->disc.x);
    }
  }
}

}  // namespace
}  // namespace circle_voronoi
