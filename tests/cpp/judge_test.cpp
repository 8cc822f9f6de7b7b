// SPDX-License-Identifier: GPL-3.0-or-later
// The judge on duals small enough to be written down.
#include "judge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "dual_edits.h"
#include "small_duals.h"

namespace circle_voronoi {
namespace {

using Triple = std::array<int, 3>;

/// The dual of faces given by their corners, in which two corners share one edge.
Dual dualOfFaces(const std::vector<Triple>& faces) {
  Dual dual;
  std::map<std::pair<int, int>, int> halfEdges;
  for (const Triple& face : faces) {
    for (int i = 0; i < 3; ++i) {
      EXPECT_TRUE(halfEdges.emplace(std::pair(face[i], face[(i + 1) % 3]), dual.halfEdgeCount()).second);
      dual.origin.push_back(face[i]);
    }
  }
  for (int h = 0; h < dual.halfEdgeCount(); ++h) dual.twin.push_back(halfEdges.at({dual.target(h), dual.origin[h]}));
  return dual;
}

Verdict judged(const std::vector<Circle>& circles, const Dual& dual) {
  Predicates predicates(circles);
  return judge(circles, dual, predicates);
}

/// Circles in a row: the faces are all at infinity, the hull goes a, b, c, b.
Dual rowInOrder(const std::array<int, 3>& circles) {
  const auto [a, b, c] = circles;
  return {{b, a, kPointAtInfinity, c, b, kPointAtInfinity, b, c, kPointAtInfinity, a, b, kPointAtInfinity},
          {9, 11, 4, 6, 2, 7, 3, 5, 10, 0, 8, 1}};
}

const std::vector<Circle> kTriangle = {{0, 0, 1}, {10, 0, 2}, {4, 8, 1}};
const Dual kTriangleDual =
    dualOfFaces({{0, 1, 2}, {1, 0, kPointAtInfinity}, {2, 1, kPointAtInfinity}, {0, 2, kPointAtInfinity}});

const std::vector<Circle> kSquare = {{0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {0, 4, 1}};
const std::vector<Triple> kOutsideOfSquare = {
    {1, 0, kPointAtInfinity}, {2, 1, kPointAtInfinity}, {3, 2, kPointAtInfinity}, {0, 3, kPointAtInfinity}};

Dual squareWith(const Triple& first, const Triple& second) {
  std::vector<Triple> faces = kOutsideOfSquare;
  faces.insert(faces.end(), {first, second});
  return dualOfFaces(faces);
}

TEST(Judge, AcceptsFewerThanTwoCirclesWithoutFaces) {
  EXPECT_TRUE(judged({}, {}).isRight());
  EXPECT_TRUE(judged({{1, 2, 3}}, {}).isRight());
  EXPECT_EQ(judged({}, kTriangleDual).flaw, Flaw::eulerCount);
  EXPECT_EQ(judged({{1, 2, 3}}, kTriangleDual).flaw, Flaw::eulerCount);
}

TEST(Judge, AcceptsTwoCirclesAndATriangle) {
  EXPECT_TRUE(
      judged({{0, 0, 1}, {5, 0, 2}}, dualOfFaces({{0, 1, kPointAtInfinity}, {1, 0, kPointAtInfinity}})).isRight());
  EXPECT_TRUE(judged(kTriangle, kTriangleDual).isRight());
}

TEST(Judge, RefusesAnotherNumberOfFaces) {
  std::vector<Circle> four = kTriangle;
  four.push_back({50, 50, 1});
  EXPECT_EQ(judged(four, kTriangleDual).flaw, Flaw::eulerCount);
  EXPECT_EQ(judged({kTriangle[0], kTriangle[1]}, kTriangleDual).flaw, Flaw::eulerCount);
}

TEST(Judge, NamesTheHalfEdgeThatDoesNotFit) {
  for (int h = 0; h < kTriangleDual.halfEdgeCount(); ++h) {
    for (const int wrong : {-1, kTriangleDual.halfEdgeCount(), h, Dual::next(h)}) {
      Dual dual = kTriangleDual;
      dual.twin[h] = wrong;
      const Verdict verdict = judged(kTriangle, dual);
      EXPECT_EQ(verdict.flaw, Flaw::adjacency);
      // The first half-edge that is not the twin of its twin: the changed half-edge, or its former twin.
      EXPECT_EQ(verdict.halfEdge, std::min(h, kTriangleDual.twin[h]));
      EXPECT_EQ(verdict.face, verdict.halfEdge / 3);
    }
  }
}

TEST(Judge, RefusesAnEdgeFromACircleToItself) {
  Dual dual = kTriangleDual;
  for (const int h : {0, 1, 3, 4}) dual.origin[h] = 1;
  dual.twin[0] = 3;
  dual.twin[3] = 0;
  const Verdict verdict = judged(kTriangle, dual);
  EXPECT_EQ(verdict.flaw, Flaw::badIndex);
  EXPECT_EQ(verdict.halfEdge, 0);
}

TEST(Judge, RefusesAFaceTheOtherWayRound) {
  const Dual mirrored =
      dualOfFaces({{1, 0, 2}, {0, 1, kPointAtInfinity}, {1, 2, kPointAtInfinity}, {2, 0, kPointAtInfinity}});
  const Verdict verdict = judged(kTriangle, mirrored);
  EXPECT_EQ(verdict.flaw, Flaw::vertexWithoutDisc);
  EXPECT_EQ(verdict.face, 0);
}

TEST(Judge, TakesEitherDiagonalOfASquareAndOneOfARhombus) {
  const Dual one = squareWith({0, 1, 2}, {0, 2, 3});
  const Dual other = squareWith({0, 1, 3}, {1, 2, 3});
  EXPECT_TRUE(judged(kSquare, one).isRight());
  EXPECT_TRUE(judged(kSquare, other).isRight());
  // One unit in the last place decides.
  std::vector<Circle> flat = kSquare;
  flat[2].x = std::nextafter(4.0, 0.0);
  EXPECT_TRUE(judged(flat, one).isRight());
  const Verdict verdict = judged(flat, other);
  EXPECT_EQ(verdict.flaw, Flaw::edgeOutOfOrder);
  const int h = verdict.halfEdge;
  EXPECT_EQ((std::minmax({other.origin[h], other.target(h)})), (std::pair(1, 3)));
}

TEST(Judge, RefusesARowInAnotherOrder) {
  const std::vector<Circle> row = {{0, 0, 1}, {5, 0, 1}, {10, 0, 1}};
  EXPECT_TRUE(judged(row, rowInOrder({0, 1, 2})).isRight());
  EXPECT_TRUE(judged(row, rowInOrder({2, 1, 0})).isRight());
  // No face and no edge shows it: all are at infinity. The cells turn too far or not at all.
  const Verdict verdict = judged(row, rowInOrder({1, 0, 2}));
  EXPECT_EQ(verdict.flaw, Flaw::cellNotClosed);
  EXPECT_NE(verdict.circle, kNone);
}

TEST(Judge, RefusesAHullThatLeavesACircleOut) {
  // Circle 3 sticks out of the triangle, but lies in the face of the other two and infinity as if it were inside.
  std::vector<Circle> circles = kTriangle;
  circles.push_back({5, 2.5, 0.5});
  Dual inside = kTriangleDual;
  test::insertInFace(inside, 0, 3);
  ASSERT_TRUE(judged(circles, inside).isRight());
  circles[3] = {5, -30, 0.5};
  EXPECT_FALSE(judged(circles, inside).isRight());
  Dual outside = kTriangleDual;
  test::insertInFace(outside, 1, 3);
  EXPECT_TRUE(judged(circles, outside).isRight());
  circles[3] = {5, 2.5, 0.5};
  EXPECT_FALSE(judged(circles, outside).isRight());
}

// Three circles and infinity make a sphere of 4 faces, nine others a torus of 18. Together they have the same number of
// faces as a sphere of twelve circles and infinity.
TEST(Judge, RefusesASphereAndATorus) {
  std::vector<Triple> faces = {{0, 1, 2}, {1, 0, kPointAtInfinity}, {2, 1, kPointAtInfinity}, {0, 2, kPointAtInfinity}};
  const auto at = [](int x, int y) { return 3 + x % 3 + 3 * (y % 3); };
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 3; ++x) {
      faces.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      faces.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  }
  const Dual dual = dualOfFaces(faces);
  std::vector<Circle> circles = {{-100, -100, 1}, {100, -100, 2}, {0, 100, 1}};
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 3; ++x) circles.push_back({x + 0.3 * y, y + 0.1 * x, 0.1});
  }
  const Verdict verdict = judged(circles, dual);
  EXPECT_FALSE(verdict.isRight());
  // It passes the checks of structure.
  EXPECT_NE(verdict.flaw, Flaw::adjacency);
  EXPECT_NE(verdict.flaw, Flaw::eulerCount);
}

TEST(Judge, SaysTheSameOfTheSameDualNumberedAnew) {
  for (const Family family : test::kFamilies) {
    const auto circles = test::visibleCircles(family, 25, 4);
    const Dual right = *test::solve(circles);
    Dual turned;
    // The faces in reverse, each from its second corner.
    const int last = right.faceCount() - 1;
    const auto moved = [&](int h) { return 3 * (last - h / 3) + (h + 2) % 3; };
    turned.origin.resize(right.origin.size());
    turned.twin.resize(right.twin.size());
    for (int h = 0; h < right.halfEdgeCount(); ++h) {
      turned.origin[moved(h)] = right.origin[h];
      turned.twin[moved(h)] = moved(right.twin[h]);
    }
    EXPECT_TRUE(judged(circles, turned).isRight());
  }
}

}  // namespace
}  // namespace circle_voronoi
