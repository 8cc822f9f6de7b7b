// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "circle_voronoi_families/families.h"
#include "delaunay.h"
#include "rounded.h"

namespace circle_voronoi {
namespace {

Samples sample(const std::vector<Circle>& circles, int angular) {
  std::vector<Point> centers;
  for (const Circle& c : circles) centers.push_back({c.x, c.y});
  return sampleDynamically(circles, delaunay(centers).dual, std::vector<int>(circles.size(), angular));
}

std::int64_t countOn(const Samples& samples, int circle) { return std::ranges::count(samples.circles, circle); }

/// Table 1 of the paper: samples on the largest circle of figure 7, on each other one, and on average.
void expectTable1(std::size_t count, std::int64_t onLargest, double average) {
  const auto circles = generate(Family::ring, count, 1);
  const Samples samples = sample(circles, 3);
  EXPECT_EQ(countOn(samples, 0), onLargest);
  for (std::size_t i = 1; i < count; ++i) EXPECT_EQ(countOn(samples, static_cast<int>(i)), 9) << "circle " << i;
  const double thousandths = std::round(1000 * static_cast<double>(samples.points.size()) / static_cast<double>(count));
  EXPECT_EQ(thousandths / 1000, average);
}

TEST(Samples, AreAsManyAsTable1SaysForFigure7a) { expectTable1(49, 192, 12.735); }
TEST(Samples, AreAsManyAsTable1SaysForFigure7b) { expectTable1(199, 792, 12.935); }

TEST(Samples, LieOnTheirCircleLessTheSmallestRadius) {
  const auto circles = generate(Family::uniform, 100, 3);
  double smallest = 1;
  for (const Circle& c : circles) smallest = std::min(smallest, c.r);
  const Samples samples = sample(circles, 2);
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    const Circle& c = circles[samples.circles[i]];
    const Vector v = {samples.points[i].x - c.x, samples.points[i].y - c.y};
    EXPECT_NEAR(length(v), c.r - smallest, 1e-14 * (10 + std::abs(c.x) + std::abs(c.y)));
  }
}

// The exact predicates of the triangulation rely on it.
TEST(Samples, AreRoundedLikeCircles) {
  const std::vector<Circle> circles = {{0, 0, 0}, {0x1p-60, 0x1p-70, 0x1p-62}, {0, 0x1p-59, 0x1p-96}, {1, 2, 0x1p-61}};
  for (const Point p : sample(circles, 3).points) EXPECT_EQ(p, rounded(p));
  for (const Point p : sampleUniformly(circles, 7).points) EXPECT_EQ(p, rounded(p));
}

// A triangle of centers has two Delaunay edges and one finite face at each; the infinite face is not subdivided.
TEST(Samples, SubdivideFiniteFacesOnly) {
  const std::vector<Circle> triangle = {{0, 0, 1}, {9, 0, 2}, {0, 9, 3}};
  EXPECT_EQ(sample(triangle, 0).points.size(), 6U);
  EXPECT_EQ(sample(triangle, 1).points.size(), 9U);
  EXPECT_EQ(sample(triangle, 3).points.size(), 15U);
}

TEST(Samples, DivideAFacesAngleIntoEqualParts) {
  const std::vector<Circle> triangle = {{0, 0, 2}, {9, 0, 1}, {0, 9, 1}};
  const Samples samples = sample(triangle, 2);
  // At the right angle: 0, 30, 60 and 90 degrees on a circle of radius 2 - 1.
  std::vector<double> heights;
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    if (samples.circles[i] == 0) heights.push_back(samples.points[i].y);
  }
  std::ranges::sort(heights);
  ASSERT_EQ(heights.size(), 4U);
  EXPECT_NEAR(heights[0], 0, 1e-15);
  EXPECT_NEAR(heights[1], 0.5, 1e-15);
  EXPECT_NEAR(heights[2], std::sqrt(0.75), 1e-15);
  EXPECT_NEAR(heights[3], 1, 1e-15);
}

TEST(Samples, DivideAnAngleThatIsStraightUpToRoundingOnTheSideOfTheFace) {
  // The face lies below the last center, and so does what divides the angle there.
  const Samples samples = sample({{-1, 0, 1}, {1, 0, 1}, {0, 1e-12, 3}}, 1);
  const bool isBelow = std::ranges::any_of(samples.points, [](Point p) { return std::abs(p.x) < 1e-9 && p.y < -1.9; });
  EXPECT_TRUE(isBelow);
}

TEST(Samples, MayDifferFromCircleToCircle) {
  const std::vector<Circle> triangle = {{0, 0, 1}, {9, 0, 2}, {0, 9, 3}};
  const std::vector<Point> centers = {{0, 0}, {9, 0}, {0, 9}};
  const Samples samples = sampleDynamically(triangle, delaunay(centers).dual, std::vector<int>{0, 1, 5});
  EXPECT_EQ(countOn(samples, 0), 2);
  EXPECT_EQ(countOn(samples, 1), 3);
  EXPECT_EQ(countOn(samples, 2), 7);
}

TEST(Samples, OfCollinearCentersLieAlongTheirLine) {
  const std::vector<Circle> row = {{0, 0, 1}, {5, 0, 2}, {9, 0, 1}};
  const Samples samples = sample(row, 3);
  EXPECT_EQ(samples.points.size(), 4U);
  for (const Point& p : samples.points) EXPECT_EQ(p.y, 0);
}

TEST(Samples, AreFiniteWhereDistancesAreTheSmallest) {
  const std::vector<Circle> circles = {{0, 0, 0}, {0x1p-90, 0x1p-96, 0}, {8, 0, 3}};
  const std::vector<Point> centers = {{0, 0}, {0x1p-90, 0x1p-96}, {8, 0}};
  const Samples samples = sampleDynamically(circles, delaunay(centers).dual, std::vector<int>{3, 3, 3});
  EXPECT_FALSE(samples.points.empty());
  for (const Point& p : samples.points) EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
}

TEST(Samples, UniformOnesAreEquallySpaced) {
  const Samples samples = sampleUniformly(std::vector<Circle>{{0, 0, 1}, {9, 0, 0}}, 5);
  ASSERT_EQ(samples.points.size(), 10U);
  for (int i = 0; i < 5; ++i) {
    const Point p = samples.points[i];
    const Point q = samples.points[(i + 1) % 5];
    EXPECT_NEAR(length({p.x - q.x, p.y - q.y}), 1.1755705045849463, 1e-14) << "the side of a regular pentagon";
  }
}

}  // namespace
}  // namespace circle_voronoi
