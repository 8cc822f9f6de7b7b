// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/merged.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "circle_voronoi/compute.h"
#include "circle_voronoi_families/families.h"
#include "near_vertices.h"

namespace circle_voronoi {
namespace {

using Around = std::vector<std::int32_t>;

TEST(Merged, GridHasVerticesOfDegreeFour) {
  std::vector<Circle> circles;
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 10; ++x) circles.push_back({0.1 * x, 0.1 * y, 0.03});
  }
  const Diagram diagram = compute(circles).value();
  const MergedDiagram merged = mergeVertices(diagram);
  ASSERT_EQ(diagram.vertices.size(), 162u);
  ASSERT_EQ(merged.vertices.size(), 81u);
  for (std::size_t v = 0; v < 81; ++v) EXPECT_EQ(merged.firstCircle[v + 1] - merged.firstCircle[v], 4);
  EXPECT_EQ(merged.edges.size(), 180u);  // 9 * 10 in each direction
  // The four circles of a square, counter-clockwise: i, i + 1, i + 11, i + 10.
  for (std::size_t v = 0; v < 81; ++v) {
    const CircleIndex* around = &merged.circles[merged.firstCircle[v]];
    EXPECT_EQ((Around{around, around + 4}), (Around{around[0], around[0] + 1, around[0] + 11, around[0] + 10}));
  }
}

TEST(Merged, EachVertexIsWhereTheFirstOfItsMergedVertexIs) {
  for (const Family family : {Family::grid, Family::hexagonal, Family::cocircularEqual, Family::uniform}) {
    const auto circles = generate(family, 200, 1);
    const Diagram diagram = compute(circles).value();
    const auto& merged = mergeVertices(diagram).mergedVertex;
    const auto firstHere = firstVerticesHere(diagram);
    ASSERT_EQ(firstHere.size(), merged.size());
    for (std::size_t v = 0; v < merged.size(); ++v) {
      EXPECT_EQ(firstHere[v], std::ranges::find(merged, merged[v]) - merged.begin());
    }
  }
}

TEST(Merged, CocircularCirclesMeetInOneVertex) {
  const auto circles = generate(Family::cocircularEqual, 100, 1);
  const MergedDiagram merged = mergeVertices(compute(circles).value());
  ASSERT_EQ(merged.vertices.size(), 1u);
  EXPECT_EQ(merged.circles.size(), 100u);
  EXPECT_EQ(merged.edges.size(), 100u);
}

TEST(Merged, GeneralPositionStaysAsItIs) {
  const auto circles = generate(Family::logUniform, 300, 5);
  const Diagram diagram = compute(circles).value();
  const MergedDiagram merged = mergeVertices(diagram);
  EXPECT_EQ(merged.vertices, diagram.vertices);
  EXPECT_EQ(merged.edges, diagram.edges);
}

TEST(Merged, LargeNearZeroMergesAll) {
  const auto circles = generate(Family::uniform, 50, 2);
  const MergedDiagram merged = mergeVertices(compute(circles).value(), 1e6);
  EXPECT_EQ(merged.vertices.size(), 1u);
  EXPECT_EQ(mergeVertices(Diagram{}).vertices.size(), 0u);
}

TEST(Merged, NearZeroOfNothingMergesEqualPlacesAlone) {
  // The first four meet in the origin, the next four nearly in (100, 0).
  const std::vector<Circle> circles = {{-1, 0, 0}, {1, 0, 0},   {0, -1, 0},   {0, 1, 0},
                                       {99, 0, 0}, {101, 0, 0}, {100, -1, 0}, {100, 1 + 1e-13, 0}};
  const Diagram diagram = compute(circles).value();
  const auto countNear = [](const std::vector<Vertex>& vertices, double x) {
    return std::ranges::count_if(vertices, [x](const Vertex& v) { return std::abs(v.x - x) + std::abs(v.y) < 1e-6; });
  };
  ASSERT_EQ(countNear(diagram.vertices, 0), 2);
  ASSERT_EQ(countNear(diagram.vertices, 100), 2);
  EXPECT_EQ(countNear(mergeVertices(diagram).vertices, 0), 1);
  EXPECT_EQ(countNear(mergeVertices(diagram).vertices, 100), 1);
  EXPECT_EQ(countNear(mergeVertices(diagram, 0).vertices, 0), 1);
  EXPECT_EQ(countNear(mergeVertices(diagram, 0).vertices, 100), 2);
}

}  // namespace
}  // namespace circle_voronoi
