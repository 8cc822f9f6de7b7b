// SPDX-License-Identifier: GPL-3.0-or-later
#include "spatial_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "centers.h"
#include "circle_voronoi_families/families.h"

namespace circle_voronoi {
namespace {

std::vector<Point> uniformPoints(std::size_t count) { return centersOf(generate(Family::points, count, 1)); }

/// The length of the way through points in their spatial order, less its longest steps.
double lengthOfWay(const std::vector<Point>& points, std::size_t longestSteps) {
  const std::vector<int> order = spatialOrder(points);
  std::vector<double> steps;
  for (std::size_t i = 1; i < order.size(); ++i) {
    const Point& p = points[order[i - 1]];
    const Point& q = points[order[i]];
    steps.push_back(length({q.x - p.x, q.y - p.y}));
  }
  std::ranges::sort(steps);
  return std::accumulate(steps.begin(), steps.end() - static_cast<std::ptrdiff_t>(longestSteps), 0.0);
}

TEST(SpatialOrder, IsAPermutation) {
  for (const std::size_t count : {0, 1, 2, 100, 5000}) {
    std::vector<int> order = spatialOrder(uniformPoints(count));
    std::ranges::sort(order);
    std::vector<int> all(count);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(order, all);
  }
}

TEST(SpatialOrder, GoesFromNeighborToNeighbor) {
  // Points at density 1: the way through them all is at least about 0.71 a point, and at most 1 along a Hilbert curve.
  EXPECT_LT(lengthOfWay(uniformPoints(10000), 0), 1.1 * 10000);
}

TEST(SpatialOrder, EqualPointsFollowOneAnother) {
  // In one cell of the curve: a point, another next to it, and the first again.
  std::vector<Point> points = uniformPoints(1000);
  for (std::size_t i = 0; i < 1000; ++i) {
    points.push_back({points[i].x + 1e-6, points[i].y});
    points.push_back(points[i]);
  }
  const std::vector<int> order = spatialOrder(points);
  std::vector<std::size_t> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) place[static_cast<std::size_t>(order[k])] = k;
  for (std::size_t i = 0; i < 1000; ++i) EXPECT_EQ(place[1001 + 2 * i], place[i] + 1) << i;
}

TEST(SpatialOrder, IsAsGoodWithAnOutlier) {
  for (const double far : {1e6, 1e9, 1e15}) {
    std::vector<Point> points = uniformPoints(10000);
    points[1234] = {far, 0};
    EXPECT_LT(lengthOfWay(points, 2), 1.1 * 10000) << far;
  }
}

TEST(SpatialOrder, IsAsGoodInClustersAtEveryScale) {
  // A cluster beside a hundred million times smaller one, and so on: each as good as alone.
  std::vector<Point> points;
  double scale = 1;
  double expected = 0;
  for (int cluster = 0; cluster < 8; ++cluster) {
    for (const Point& p : uniformPoints(1000)) points.push_back({scale * (p.x + 1), scale * (p.y + 1)});
    expected += 1.2 * 1000 * scale;
    scale *= 1e-8;
  }
  EXPECT_LT(lengthOfWay(points, 7), expected);
  // The smallest cluster has the same order as alone.
  const std::vector<Point> last(points.end() - 1000, points.end());
  std::vector<int> inside;
  for (const int i : spatialOrder(points)) {
    if (i >= 7000) inside.push_back(i - 7000);
  }
  EXPECT_EQ(inside, spatialOrder(last));
}

TEST(SpatialOrder, KeepsEqualPointsInTheirOrder) {
  std::vector<Point> points = uniformPoints(100);
  for (int copy = 0; copy < 50; ++copy) points.push_back(points[7]);
  std::vector<int> copies;
  for (const int i : spatialOrder(points)) {
    if (i == 7 || i >= 100) copies.push_back(i);
  }
  EXPECT_EQ(copies.size(), 51U);
  EXPECT_TRUE(std::ranges::is_sorted(copies));
}

TEST(SpatialOrder, IsTheSameAtEveryScale) {
  const std::vector<Point> points = uniformPoints(1000);
  std::vector<Point> scaled = points;
  // Rounded to whole numbers, so that the smallest scale rounds nothing.
  for (Point& p : scaled) p = {std::round(1e6 * p.x), std::round(1e6 * p.y)};
  const std::vector<int> order = spatialOrder(scaled);
  for (const int exponent : {-1074, -1040, -1000, -900, 0, 60}) {
    std::vector<Point> small = scaled;
    for (Point& p : small) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
    EXPECT_EQ(spatialOrder(small), order) << exponent;
  }
}

}  // namespace
}  // namespace circle_voronoi
