// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/clearest_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

#include "circle_voronoi/box.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi_families/families.h"
#include "parameters.h"
#include "path_checks.h"
#include "random.h"
#include "regions.h"
#include "vectors.h"

namespace circle_voronoi {
namespace {

double clearanceAt(const std::vector<Circle>& circles, Point p) { return test::clearanceAlong(circles, p, p); }

/// A grid of pixels over a square: the greatest clearance with which pixels that touch lead from one to another.
class Pixels {
 public:
  Pixels(const std::vector<Circle>& circles, const Box& box) : box_(box) {
    for (int i = 0; i < kCount * kCount; ++i) clearance_.push_back(clearanceAt(circles, center(i)));
  }

  double pixel() const { return (box_.maxX - box_.minX) / kCount; }

  double between(Point p, Point q) const {
    std::vector<int> order(clearance_.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, std::ranges::greater(), [&](int i) { return clearance_[static_cast<std::size_t>(i)]; });
    std::vector<int> parent(clearance_.size(), -1);
    const std::function<int(int)> root = [&](int i) {
      int& up = parent[static_cast<std::size_t>(i)];
      return up == i ? i : up = root(up);
    };
    const int from = index(p);
    const int to = index(q);
    for (const int i : order) {
      parent[static_cast<std::size_t>(i)] = i;
      const int row = i / kCount;
      const int column = i % kCount;
      for (int dr = -1; dr <= 1; ++dr) {
        for (int dc = -1; dc <= 1; ++dc) {
          if (row + dr < 0 || row + dr >= kCount || column + dc < 0 || column + dc >= kCount) continue;
          const int other = i + dr * kCount + dc;
          if (parent[static_cast<std::size_t>(other)] >= 0) parent[static_cast<std::size_t>(root(other))] = root(i);
        }
      }
      const bool hasBoth = parent[static_cast<std::size_t>(from)] >= 0 && parent[static_cast<std::size_t>(to)] >= 0;
      if (hasBoth && root(from) == root(to)) return clearance_[static_cast<std::size_t>(i)];
    }
    return -std::numeric_limits<double>::infinity();
  }

 private:
  static constexpr int kCount = 150;

  Point center(int i) const {
    return {box_.minX + (i % kCount + 0.5) * pixel(), box_.minY + (i / kCount + 0.5) * pixel()};
  }
  int index(Point p) const {
    return static_cast<int>((p.y - box_.minY) / pixel()) * kCount + static_cast<int>((p.x - box_.minX) / pixel());
  }

  Box box_;
  std::vector<double> clearance_;
};

class ClearestPaths : public testing::TestWithParam<Family> {};

TEST_P(ClearestPaths, AreAsClearAsThoseOfPixels) {
  Random random(1);
  for (const std::size_t count : {1U, 2U, 3U, 12U}) {
    SCOPED_TRACE(count);
    const auto circles = generate(GetParam(), count, count);
    const Diagram diagram = compute(circles).value();
    const Box box = test::boundingBoxOf(circles);
    // Pixels are larger than rounding, even around a single point far from the origin.
    const double least = 1e-9 * (std::abs(box.minX) + std::abs(box.minY)) + 1e-12;
    const double size = std::max({box.maxX - box.minX, box.maxY - box.minY, least});
    // Room to go around everything.
    const Pixels pixels(circles, {box.minX - size, box.minY - size, box.minX + 2 * size, box.minY + 2 * size});
    for (int trial = 0; trial < 3; ++trial) {
      const Point p = {random.uniform(box.minX, box.minX + size), random.uniform(box.minY, box.minY + size)};
      const Point q = {random.uniform(box.minX, box.minX + size), random.uniform(box.minY, box.minY + size)};
      const ClearestPath path = clearestPath(diagram, p, q);
      EXPECT_NEAR(path.clearance, pixels.between(p, q), 2 * pixels.pixel());
      EXPECT_NEAR(path.clearance, clearestPath(diagram, q, p).clearance, 1e-12 * size);
      EXPECT_LE(path.clearance, clearanceAt(circles, p) + 1e-12 * (size + std::abs(p.x) + std::abs(p.y)));
    }
  }
}

TEST_P(ClearestPaths, FollowEdgesThatMeet) {
  Random random(2);
  const auto circles = generate(GetParam(), 40, 7);
  const Diagram diagram = compute(circles).value();
  for (int trial = 0; trial < 20; ++trial) {
    const Circle& c = circles[random.below(circles.size())];
    const Circle& d = circles[random.below(circles.size())];
    const ClearestPath path = clearestPath(diagram, {c.x + c.r, c.y}, {d.x, d.y - d.r});
    for (std::size_t k = 1; k < path.edges.size(); ++k) {
      const Edge& e = diagram.edges[static_cast<std::size_t>(path.edges[k - 1])];
      const Edge& f = diagram.edges[static_cast<std::size_t>(path.edges[k])];
      EXPECT_TRUE(e.start == f.start || e.start == f.end || e.end == f.start || e.end == f.end);
    }
    const double size = 1 + std::abs(c.x) + c.r;
    EXPECT_GE(clearanceAt(circles, path.entry.value_or(Point{c.x + c.r, c.y})), path.clearance - 1e-9 * size);
  }
}

INSTANTIATE_TEST_SUITE_P(Families, ClearestPaths, testing::ValuesIn(test::familiesWhere([](Family) { return true; })),
                         test::NameOfParameter());

TEST(ClearestPaths, GoThroughTheWiderGap) {
  // A ring of six circles with gaps of 1; a smaller circle has gaps of 1.5.
  const double h = 5 * std::numbers::sqrt3 / 2;
  const std::vector<Circle> circles = {{5, 0, 2}, {2.5, h, 2}, {-2.5, h, 2}, {-5, 0, 1.5}, {-2.5, -h, 2}, {2.5, -h, 2}};
  const Diagram diagram = compute(circles).value();
  EXPECT_NEAR(clearestPath(diagram, {0.1, 0}, {20, 0}).clearance, 0.75, 1e-12);
  // Outside there is room without limit: the ends alone bound the clearance.
  EXPECT_NEAR(clearestPath(diagram, {0, 20}, {0, -20}).clearance, std::sqrt(2.5 * 2.5 + (20 - h) * (20 - h)) - 2,
              1e-12);
}

TEST(ClearestPaths, StartAnywhere) {
  const std::vector<Circle> circles = {{0, 0, 1}, {8, 0, 1}, {0, 8, 1}, {-8, 0, 1}, {0, -8, 1}};
  const Diagram diagram = compute(circles).value();
  const ClearestPath path = clearestPath(diagram, {0, 0}, {30, 1});
  // Squares of these lengths would be 0 or infinite.
  for (const Point p : {Point{-1e-300, 0}, Point{0, 1e-160}}) {
    EXPECT_EQ(clearestPath(diagram, p, {30, 1}).edges, path.edges);
    const ClearestPath far = clearestPath(diagram, p, {1e300, 1e299});
    ASSERT_TRUE(far.entry.has_value());
    EXPECT_EQ(far.entry->x, 4);
    EXPECT_EQ(far.entry->y, 0);
    EXPECT_EQ(far.clearance, -1);
  }
  EXPECT_FALSE(clearestPath(diagram, {-1e300, 0}, {30, 1}).entry.has_value());
}

TEST(ClearestPaths, EndAmongTheSmallestCircles) {
  const std::vector<Circle> circles = {
      {0, 0, 1e-28}, {1e-27, 0, 2e-28}, {0, 1e-27, 3e-28}, {9e-28, 9e-28, 5e-29}, {1, 0, 0}};
  const Diagram diagram = compute(circles).value();
  const ClearestPath path = clearestPath(diagram, {0, 0}, {1e-27, 1e-27});
  EXPECT_LE(path.edges.size(), diagram.edges.size());
}

}  // namespace
}  // namespace circle_voronoi
