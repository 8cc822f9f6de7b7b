// SPDX-License-Identifier: GPL-3.0-or-later
// The comparison that the other tests trust: it must see every kind of damage.
#include "compare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "circle_voronoi/compute.h"
#include "circle_voronoi_families/families.h"
#include "oracle.h"

namespace circle_voronoi {
namespace {

class Compare : public testing::Test {
 protected:
  /// The result of the comparison after damage to a right diagram.
  std::string after(const std::function<void(Diagram&)>& damage) const {
    Diagram diagram = diagram_;
    damage(diagram);
    return test::problemInGeneralPosition(diagram, exact_, circles_);
  }

  std::vector<Circle> circles_ = generate(Family::hidden, 30, 1);
  Diagram diagram_ = compute(circles_).value();
  Diagram exact_ = oracle::exactDiagram(circles_);
};

TEST_F(Compare, ARightDiagramHasNoProblem) {
  EXPECT_EQ(after([](Diagram&) {}), "");
  EXPECT_EQ(after([](Diagram& d) { std::ranges::rotate(d.vertexCircles[3], d.vertexCircles[3].begin() + 1); }), "");
  EXPECT_EQ(after([](Diagram& d) { std::ranges::rotate(d.hull, d.hull.begin() + 1); }), "");
}

TEST_F(Compare, SeesDamage) {
  EXPECT_NE(after([](Diagram& d) { std::swap(d.vertexCircles[0][0], d.vertexCircles[0][1]); }), "");
  EXPECT_NE(after([](Diagram& d) { d.vertexCircles[0] = d.vertexCircles[1]; }), "");
  EXPECT_NE(after([](Diagram& d) { d.edges.pop_back(); }), "");
  EXPECT_NE(after([](Diagram& d) { std::swap(d.edges[0].left, d.edges[0].right); }), "");
  EXPECT_NE(after([](Diagram& d) { std::swap(d.edges[0].start, d.edges[1].start); }), "");
  EXPECT_NE(after([](Diagram& d) { d.edges[0].end = 1000; }), "");
  EXPECT_NE(after([](Diagram& d) { d.hidden.pop_back(); }), "");
  EXPECT_NE(after([](Diagram& d) { d.hidden[0].by = d.hidden[1].circle; }), "");
  EXPECT_NE(after([](Diagram& d) { std::ranges::reverse(d.hull); }), "");
  EXPECT_NE(after([](Diagram& d) { d.hull.pop_back(); }), "");
  EXPECT_NE(after([](Diagram& d) { d.vertices.pop_back(); }), "");
}

TEST_F(Compare, SeesTheDiagramOfOtherCircles) {
  auto others = circles_;
  for (Circle& c : others) c.r = 0.1;
  const Diagram diagram = compute(others).value();
  EXPECT_NE(test::problemInGeneralPosition(diagram, exact_, circles_), "");
  EXPECT_NE(test::problemInDegeneratePosition(diagram, exact_, circles_), "");
}

// The four circles of a square share one disc, whichever diagonal splits it.
TEST(CompareAfterMerging, TheChoiceOfTrivalentVerticesDoesNotMatter) {
  const std::vector<Circle> square = {{0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {0, 4, 1}};
  Diagram one;
  one.vertexCircles = {{0, 1, 2}, {0, 2, 3}};
  one.edges = {{0, 1, kNone, 0}, {1, 2, kNone, 0}, {2, 3, kNone, 1}, {3, 0, kNone, 1}, {2, 0, 0, 1}};
  Diagram other;
  other.vertexCircles = {{0, 1, 3}, {1, 2, 3}};
  other.edges = {{0, 1, kNone, 0}, {1, 2, kNone, 1}, {2, 3, kNone, 1}, {3, 0, kNone, 0}, {1, 3, 0, 1}};
  EXPECT_NE(test::difference(one, other), "");
  EXPECT_EQ(test::differenceAfterMerging(one, other, square), "");

  // Not so if the circles are not on one disc.
  EXPECT_NE(test::differenceAfterMerging(one, other, std::vector<Circle>{{0, 0, 1}, {4, 0, 1}, {4, 3, 1}, {1, 4, 1}}),
            "");
}

}  // namespace
}  // namespace circle_voronoi
