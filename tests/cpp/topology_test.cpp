// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <variant>
#include <vector>

#include "small_duals.h"

namespace circle_voronoi {
namespace {

/// A triangle of circles 0, 1, 2 with 3 inside.
const Topology kTopology = {
    {{0, 1, 3}, {1, 2, 3}, {0, 3, 2}},
    {{0, 1, kNone, 0}, {1, 2, kNone, 1}, {2, 0, kNone, 2}, {1, 3, 1, 0}, {2, 3, 2, 1}, {0, 3, 0, 2}},
    {0, 1, 2}};

TopologyFlaw flawOf(const Topology& topology, int circleCount = 4) {
  const auto dual = dualOf(topology, circleCount);
  const auto* found = std::get_if<TopologyFlaw>(&dual);
  EXPECT_NE(found, nullptr);
  return found == nullptr ? TopologyFlaw{Flaw::none} : *found;
}

TEST(Topology, GoesToTheDualAndBack) {
  const auto dual = std::get<Dual>(dualOf(kTopology, 4));
  EXPECT_EQ(dual.faceCount(), 6);
  const Topology back = topologyOf(dual, 4);
  EXPECT_EQ(back.vertexCircles, kTopology.vertexCircles);
  EXPECT_EQ(back.edges.size(), kTopology.edges.size());
  for (const Edge& edge : kTopology.edges) {
    const Edge reverse = {edge.right, edge.left, edge.end, edge.start};
    EXPECT_EQ(std::count(back.edges.begin(), back.edges.end(), edge) +
                  std::count(back.edges.begin(), back.edges.end(), reverse),
              1);
  }
  std::vector<CircleIndex> hull = back.hull;
  rotateHull(hull);
  EXPECT_EQ(hull, kTopology.hull);
}

TEST(Topology, GoesToTheDualAndBackInEveryFamily) {
  for (const Family family : test::kFamilies) {
    const auto circles = test::visibleCircles(family, 60, 2);
    const auto count = static_cast<int>(circles.size());
    const Dual right = *test::solve(circles);
    const Topology topology = topologyOf(right, count);
    const auto again = std::get<Dual>(dualOf(topology, count));
    EXPECT_TRUE(test::isRight(circles, again)) << familyName(family);
    EXPECT_EQ(topologyOf(again, count).vertexCircles, topology.vertexCircles);
  }
}

TEST(Topology, HasAHullButNoVerticesForOneCircleAndForTwo) {
  EXPECT_EQ(topologyOf(Dual{}, 0).hull, (std::vector<CircleIndex>{}));
  EXPECT_EQ(topologyOf(Dual{}, 1).hull, (std::vector<CircleIndex>{0}));
  const Topology two = topologyOf(Dual{{0, 1, kPointAtInfinity, 1, 0, kPointAtInfinity}, {3, 5, 4, 0, 2, 1}}, 2);
  EXPECT_TRUE(two.vertexCircles.empty());
  ASSERT_EQ(two.edges.size(), 1U);
  EXPECT_EQ(two.edges[0].start, kNone);
  EXPECT_EQ(two.edges[0].end, kNone);
  EXPECT_EQ(two.hull.size(), 2U);
}

TEST(Topology, NamesWhatIsOutOfRangeOrTwice) {
  for (const std::int32_t bad : {-1, 4, 1}) {
    Topology topology = kTopology;
    topology.vertexCircles[1] = {bad, 1, 3};
    EXPECT_EQ(flawOf(topology).flaw, Flaw::badIndex) << bad;
    EXPECT_EQ(flawOf(topology).vertex, 1) << bad;
    topology = kTopology;
    topology.edges[4].left = bad == 1 ? 3 : bad;  // 3 is its right
    EXPECT_EQ(flawOf(topology).flaw, Flaw::badIndex) << bad;
    EXPECT_EQ(flawOf(topology).edge, 4) << bad;
    topology = kTopology;
    topology.hull[2] = bad;
    EXPECT_EQ(flawOf(topology).flaw, Flaw::badIndex) << bad;
    EXPECT_EQ(flawOf(topology).circle, bad) << bad;
  }
  EXPECT_EQ(flawOf(kTopology, 3).flaw, Flaw::badIndex);
}

TEST(Topology, NamesTheEdgeThatDoesNotFit) {
  const auto change = [](auto edit) {
    Topology topology = kTopology;
    edit(topology);
    return flawOf(topology);
  };
  // Ends swapped, out of range, or of a vertex without this pair of circles.
  EXPECT_EQ(change([](Topology& t) { std::swap(t.edges[3].start, t.edges[3].end); }).edge, 3);
  EXPECT_EQ(change([](Topology& t) { t.edges[3].end = 3; }).edge, 3);
  EXPECT_EQ(change([](Topology& t) { t.edges[3].end = -2; }).edge, 3);
  EXPECT_EQ(change([](Topology& t) { t.edges[3].end = 2; }).edge, 3);
  // An end at infinity that the hull does not have.
  EXPECT_EQ(change([](Topology& t) { t.edges[3].end = kNone; }).edge, 3);
  // One edge twice, and one missing: the second of the two is named, or the vertex left open.
  EXPECT_EQ(change([](Topology& t) { t.edges.push_back(t.edges[3]); }).edge, 6);
  const TopologyFlaw missing = change([](Topology& t) { t.edges.erase(t.edges.begin() + 3); });
  EXPECT_EQ(missing.flaw, Flaw::adjacency);
  EXPECT_EQ(missing.vertex, 0);
}

TEST(Topology, RefusesAHullThatRepeatsAStep) {
  Topology topology = kTopology;
  topology.hull = {0, 1, 2, 0, 1, 2};
  EXPECT_EQ(flawOf(topology).flaw, Flaw::adjacency);
  topology.hull.clear();
  EXPECT_EQ(flawOf(topology).flaw, Flaw::adjacency);
}

TEST(RotateHull, StartsWithTheSmallestStep) {
  const auto rotated = [](std::vector<CircleIndex> hull) {
    rotateHull(hull);
    return hull;
  };
  using Hull = std::vector<CircleIndex>;
  EXPECT_EQ(rotated({}), Hull{});
  EXPECT_EQ(rotated({7}), Hull{7});
  EXPECT_EQ(rotated({2, 1}), (Hull{1, 2}));
  EXPECT_EQ(rotated({4, 2, 9}), (Hull{2, 9, 4}));
  // Circle 0 occurs several times. The next circle decides between them, so any rotation of the hull gives the same
  // result.
  const Hull hull = {0, 3, 0, 5, 0, 4};
  for (std::size_t shift = 0; shift < hull.size(); ++shift) {
    Hull shifted = hull;
    std::rotate(shifted.begin(), shifted.begin() + static_cast<std::ptrdiff_t>(shift), shifted.end());
    EXPECT_EQ(rotated(shifted), hull) << shift;
  }
}

}  // namespace
}  // namespace circle_voronoi
