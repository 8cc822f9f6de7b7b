// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines that are small enough to write down. cells_test.cpp tests the outlines of whole diagrams.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "circle_voronoi/cells.h"
#include "circle_voronoi/compute.h"
#include "regions.h"

namespace circle_voronoi {
namespace {

/// The outlines of all cells of a few circles in a region.
std::vector<Outline> outlinesOf(const std::vector<Circle>& circles, const ConvexPolygon& region) {
  const Diagram diagram = compute(circles).value();
  std::vector<Outline> outlines;
  for (std::size_t i = 0; i < circles.size(); ++i) {
    outlines.push_back(outline(diagram, static_cast<std::int32_t>(i), region));
  }
  return outlines;
}

std::vector<std::int32_t> neighborsOf(const std::vector<OutlinePiece>& loop) {
  std::vector<std::int32_t> neighbors;
  for (const OutlinePiece& piece : loop) neighbors.push_back(piece.neighbor);
  std::ranges::sort(neighbors);
  return neighbors;
}

TEST(Outline, OfTwoEqualCirclesHalvesTheBox) {
  const auto outlines = outlinesOf({{0, 0, 1}, {4, 0, 1}}, test::regionOf(Box{-1, -3, 5, 3}));
  for (const std::size_t i : {0U, 1U}) {
    ASSERT_EQ(outlines[i].size(), 1U);
    EXPECT_EQ(area(outlines[i]), 18);
    EXPECT_EQ(perimeter(outlines[i]), 18);
    EXPECT_EQ(centroid(outlines[i]), (Point{i == 0 ? 0.5 : 3.5, 0}));
    // One piece along the other cell, the rest along the box.
    const auto neighbors = neighborsOf(outlines[i][0]);
    EXPECT_EQ(std::ranges::count(neighbors, static_cast<std::int32_t>(1 - i)), 1);
    EXPECT_EQ(std::ranges::count(neighbors, kNone), static_cast<std::ptrdiff_t>(neighbors.size()) - 1);
  }
}

TEST(Outline, OfFourCirclesQuartersTheBox) {
  const auto outlines = outlinesOf({{0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {0, 4, 1}}, test::regionOf(Box{-2, -2, 6, 6}));
  for (const Outline& one : outlines) {
    ASSERT_EQ(one.size(), 1U);
    EXPECT_EQ(area(one), 16);
    EXPECT_EQ(perimeter(one), 16);
  }
}

TEST(Outline, OfARegionInsideACellIsTheRegion) {
  const std::vector<Circle> circles = {{0, 0, 5}, {100, 0, 1}};
  const ConvexPolygon triangle = ConvexPolygon::from(std::vector<Point>{{0, 0}, {4, 0}, {0, 3}}).value();
  const auto outlines = outlinesOf(circles, triangle);
  EXPECT_TRUE(outlines[1].empty());
  ASSERT_EQ(outlines[0].size(), 1U);
  EXPECT_EQ(outlines[0][0].size(), 3U);
  for (const OutlinePiece& piece : outlines[0][0]) EXPECT_EQ(piece.side, kNone);
  EXPECT_EQ(area(outlines[0]), 6);
  EXPECT_EQ(perimeter(outlines[0]), 12);
}

// The cell of the middle one of three equal circles in a row is a strip. A box beside the strip does not meet it.
TEST(Outline, OfAStripHasNoMoreThanTheStrip) {
  const std::vector<Circle> row = {{0, 0, 1}, {4, 0, 1}, {8, 0, 1}};
  const auto across = outlinesOf(row, test::regionOf(Box{-10, -1, 20, 1}));
  EXPECT_EQ(area(across[1]), 8);
  EXPECT_EQ(neighborsOf(across[1][0]), (std::vector<std::int32_t>{kNone, kNone, 0, 2}));
  EXPECT_TRUE(outlinesOf(row, test::regionOf(Box{-10, -1, 1, 1}))[1].empty());
}

TEST(Outline, OfACellThatEndsAtACurveHasItsArea) {
  // The cell of a point beside a circle so large that it is nearly a line.
  const double huge = 1e6;
  const auto outlines = outlinesOf({{0, 1, 0}, {0, -1 - huge, huge}}, test::regionOf(Box{-2, -4, 2, 4}));
  // y > x^2 / 4 in the box: 16 - 2 * 8 / 12
  EXPECT_NEAR(area(outlines[0]), 16 - 4.0 / 3, 1e-5);
  EXPECT_NEAR(area(outlines[0]) + area(outlines[1]), 32, 1e-12);
}

// The third point's cell has its corner (2, 1.5) on the box's left side, along which it goes on.
TEST(Outline, OfACellWithItsCornerOnTheBorderHasNoPieceOfLengthZeroThere) {
  const auto outlines = outlinesOf({{4, -1, 0}, {0, 4, 0}, {4, 4, 0}}, test::regionOf(Box{2, 0, 8, 2}));
  ASSERT_EQ(outlines[2].size(), 1U);
  EXPECT_EQ(outlines[2][0].size(), 4U);
  for (const OutlinePiece& piece : outlines[2][0]) EXPECT_TRUE(piece.curve.start != piece.curve.end);
  EXPECT_EQ(area(outlines[2]), 3);
}

TEST(Outline, OfPointsThatAreFarNearerThanTheBoxIsLargeHalvesTheBox) {
  const double size = 1e28;
  const std::vector<Circle> circles = {{0x1p-56, 0, 0}, {0, 0, 0}};
  const Diagram diagram = compute(circles).value();
  for (const std::int32_t i : {0, 1}) {
    EXPECT_NEAR(area(outline(diagram, i, test::regionOf(Box{-size, -size, size, size}))) / size / size, 2, 1e-12);
  }
}

TEST(Outline, OfAHiddenCircleIsEmpty) {
  const auto outlines = outlinesOf({{0, 0, 5}, {1, 0, 1}}, test::regionOf(Box{-2, -2, 2, 2}));
  EXPECT_TRUE(outlines[1].empty());
  EXPECT_EQ(area(outlines[1]), 0);
  EXPECT_EQ(perimeter(outlines[1]), 0);
  EXPECT_EQ(centroid(outlines[1]), (Point{0, 0}));
  EXPECT_EQ(area(outlines[0]), 16);
}

}  // namespace
}  // namespace circle_voronoi
