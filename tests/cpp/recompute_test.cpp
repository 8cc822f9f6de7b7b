// SPDX-License-Identifier: GPL-3.0-or-later
#include "recompute.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <tuple>
#include <vector>

#include "circle_voronoi/certify.h"
#include "circle_voronoi/compute.h"
#include "random.h"

namespace circle_voronoi {
namespace {

/// A diagram without its numbers: each vertex with its disc, and of each edge its circles, the smaller index first.
struct Parts {
  std::vector<std::tuple<int, int, int, double, double, double>> vertices;
  std::vector<std::pair<int, int>> edges;
  std::vector<CircleIndex> hull;
  bool operator==(const Parts&) const = default;
};

Parts partsOf(const Diagram& diagram) {
  Parts parts;
  for (std::size_t v = 0; v < diagram.vertices.size(); ++v) {
    std::array<CircleIndex, 3> circles = diagram.vertexCircles[v];
    std::ranges::rotate(circles, std::ranges::min_element(circles));
    const auto& [x, y, r] = diagram.vertices[v];
    parts.vertices.emplace_back(circles[0], circles[1], circles[2], x, y, r);
  }
  for (const Edge& edge : diagram.edges) parts.edges.emplace_back(std::minmax<int>(edge.left, edge.right));
  std::ranges::sort(parts.vertices);
  std::ranges::sort(parts.edges);
  parts.hull = diagram.hull;
  return parts;
}

TEST(Recompute, GivesTheDiagramOfComputeButForNumbers) {
  Random random(61);
  int flipped = 0;
  for (int trial = 0; trial < 60; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    const std::size_t count = 1 + random.below(trial % 2 == 0 ? 8 : 300);
    std::vector<Circle> circles;
    for (std::size_t i = 0; i < count; ++i) {
      // On a grid, more than three circles touch one disc.
      const auto coordinate = [&] {
        return trial % 3 == 0 ? static_cast<double>(random.below(40)) : 40 * random.unit();
      };
      circles.push_back({coordinate(), coordinate(),
                         trial % 3 == 0 ? 0.125 * static_cast<double>(random.below(3)) : 0.3 * random.unit()});
    }
    const Diagram before = compute(circles).value();
    if (!before.hidden.empty()) continue;
    for (Circle& c : circles) {
      c.r += trial % 3 == 0 ? 0.25 : 0.2 * random.unit();
      if (trial % 4 == 0) c.x += 0.05 * random.unit();
    }
    const Diagram after = compute(circles).value();
    const auto again = recompute(before, circles);
    if (!after.hidden.empty()) {
      EXPECT_FALSE(again);
      continue;
    }
    if (!again) continue;
    ++flipped;
    EXPECT_EQ(partsOf(*again), partsOf(after));
    EXPECT_TRUE(again->certificate.certified());
    EXPECT_TRUE(certify(*again).value().certified());
    EXPECT_EQ(again->stats.counts.circles, static_cast<std::int64_t>(count));
  }
  EXPECT_GT(flipped, 30);
}

TEST(Recompute, GivesNothingWhereCirclesAreHiddenOrInvalid) {
  const std::vector<Circle> circles = {{0, 0, 1}, {5, 0, 1}, {0, 5, 1}, {5, 5, 1}};
  const Diagram before = compute(circles).value();
  EXPECT_TRUE(recompute(before, circles));
  EXPECT_FALSE(recompute(before, std::vector<Circle>{{0, 0, 9}, {5, 0, 1}, {0, 5, 1}, {5, 5, 1}}));
  EXPECT_FALSE(recompute(before, std::vector<Circle>{{0, 0, -1}, {5, 0, 1}, {0, 5, 1}, {5, 5, 1}}));
}

}  // namespace
}  // namespace circle_voronoi
