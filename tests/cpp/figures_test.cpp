// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi_families/figures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "centers.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/merged.h"
#include "delaunay.h"

namespace circle_voronoi {
namespace {

Diagram computed(std::string_view name) { return compute(circlesOf(figureOf(name))).value(); }

bool areNeighbors(const Diagram& diagram, int i, int j) {
  return std::ranges::any_of(
      diagram.edges, [&](const Edge& e) { return std::min(e.left, e.right) == i && std::max(e.left, e.right) == j; });
}

/// The number of edges of the Delaunay graph of the centers between circle 0 and circle 1.
int stepsBetweenCenters(std::string_view name) {
  const auto circles = circlesOf(figureOf(name));
  const auto edges = delaunayEdges(centersOf(circles)).edges;
  std::set<int> reached = {0};
  int steps = 0;
  for (; !reached.contains(1); ++steps) {
    const std::set<int> before = reached;
    for (const auto& [i, j] : edges) {
      if (before.contains(i)) reached.insert(j);
      if (before.contains(j)) reached.insert(i);
    }
  }
  return steps;
}

TEST(Figures, HaveNamesOfTheirOwnAndSayWhatTheyShow) {
  std::set<std::string_view> names;
  for (const Figure& figure : figures()) {
    EXPECT_TRUE(names.insert(figure.name).second) << figure.name;
    EXPECT_FALSE(figure.description.empty()) << figure.name;
  }
}

TEST(Figures, HaveCertifiedDiagrams) {
  for (const Figure& figure : figures()) {
    const auto circles = circlesOf(figure);
    EXPECT_GE(circles.size(), 4U) << figure.name;
    if (figure.count >= 1000) continue;
    EXPECT_TRUE(compute(circles).value().certificate.certified()) << figure.name;
  }
}

TEST(Figures, FiveHasNeighborsThatAreFarApartInTheGraphOfTheCenters) {
  for (const std::string_view name : {"5b", "5c", "5d"}) EXPECT_TRUE(areNeighbors(computed(name), 0, 1)) << name;
  EXPECT_EQ(stepsBetweenCenters("5b"), 2);
  EXPECT_EQ(stepsBetweenCenters("5c"), 3);
  EXPECT_GT(stepsBetweenCenters("5d"), 3);
}

TEST(Figures, NineHasAnEdgeThatVanishes) {
  for (const auto& [name, longest, shortest] : {std::tuple{"9a", 0.5, 0.05}, std::tuple{"9b", 1e-5, 1e-8}}) {
    const Diagram diagram = computed(name);
    ASSERT_EQ(diagram.vertices.size(), 2U) << name;
    const auto& [a, b] = std::pair{diagram.vertices[0], diagram.vertices[1]};
    const double length = std::hypot(a.x - b.x, a.y - b.y);
    EXPECT_LT(length, longest) << name;
    EXPECT_GT(length, shortest) << name;
    EXPECT_TRUE(areNeighbors(diagram, 0, 2)) << name;
  }
}

TEST(Figures, TenAndElevenAreOneVertex) {
  for (const auto& [name, degree] : {std::pair{"10", 12}, std::pair{"11", 4}}) {
    const MergedDiagram merged = mergeVertices(computed(name));
    ASSERT_EQ(merged.vertices.size(), 1U) << name;
    EXPECT_EQ(merged.firstCircle[1], degree) << name;
  }
}

}  // namespace
}  // namespace circle_voronoi
