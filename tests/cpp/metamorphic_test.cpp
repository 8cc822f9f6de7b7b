// SPDX-License-Identifier: GPL-3.0-or-later
// Changes of the input that must not change the diagram, or must change it in a known way. Where the arithmetic of the
// change is exact the outcome is compared exactly: circles are multiples of 2^-10 below 2^10, so that shifts and powers
// of two lose no bit. order_test.cpp tests other orders of the circles,
// weights_test.cpp adding a constant to all radii.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "circle_voronoi/compute.h"
#include "circle_voronoi_families/families.h"
#include "compare.h"
#include "delaunay.h"
#include "diagrams.h"
#include "random.h"
#include "report.h"
#include "tie_inputs.h"

namespace circle_voronoi {
namespace {

using Circles = std::vector<Circle>;

constexpr int kTrials = 8;

/// Rounding may create ties in any family, so all diagrams are compared after merging.
void expectSame(const Diagram& actual, const Diagram& expected, const Circles& circles) {
  EXPECT_EQ(test::structureProblem(actual, circles.size()), "");
  EXPECT_EQ(test::differenceAfterMerging(actual, expected, circles), "");
}

using test::diagramOf;

template <class Check>
void onEveryFamily(Check check) {
  const std::uint64_t seed = test::seedOr(1);
  for (const FamilyInfo& family : families()) {
    for (std::uint64_t trial = 0; trial < kTrials; ++trial) {
      Random random(seed * 1'000'003 + trial);
      const Circles circles = test::onDyadicGrid(generate(family.family, 2 + random.below(100), random.next()));
      SCOPED_TRACE(std::string(family.name) + ", trial " + std::to_string(trial));
      check(circles, family, random);
      if (testing::Test::HasFailure()) FAIL() << test::describe(circles);
    }
  }
}

TEST(Metamorphic, TranslationByIntegersKeepsTheTopology) {
  onEveryFamily([](const Circles& circles, const FamilyInfo&, Random& random) {
    Circles moved = circles;
    const double x = std::floor(random.uniform(-0x1p40, 0x1p40));
    const double y = std::floor(random.uniform(-0x1p40, 0x1p40));
    for (Circle& c : moved) c = {c.x + x, c.y + y, c.r};
    const Diagram actual = diagramOf(moved);
    const Diagram expected = diagramOf(circles);
    EXPECT_EQ(test::difference(actual, expected), "");
    EXPECT_EQ(actual.hull, expected.hull);
    EXPECT_EQ(actual.hidden, expected.hidden);
  });
}

TEST(Metamorphic, ScalingByPowersOfTwoScalesTheBits) {
  onEveryFamily([](const Circles& circles, const FamilyInfo&, Random& random) {
    // Larger ones up to the limit: smaller numbers could be rounded.
    double largest = 1;
    for (const Circle& c : circles) largest = std::max({largest, std::abs(c.x), std::abs(c.y), c.r});
    const int most = std::ilogb(kCoordinateLimit / largest);
    const double factor = std::ldexp(1.0, static_cast<int>(random.below(static_cast<std::size_t>(most) + 1)));
    Circles scaled = circles;
    for (Circle& c : scaled) c = {c.x * factor, c.y * factor, c.r * factor};
    const Diagram actual = diagramOf(scaled);
    Diagram expected = diagramOf(circles);
    for (Vertex& v : expected.vertices) v = {v.x * factor, v.y * factor, v.r * factor};
    EXPECT_EQ(actual.vertices, expected.vertices);
    EXPECT_EQ(actual.vertexCircles, expected.vertexCircles);
    EXPECT_EQ(actual.edges, expected.edges);
    EXPECT_EQ(actual.hidden, expected.hidden);
    EXPECT_EQ(actual.hull, expected.hull);
  });
}

TEST(Metamorphic, ReflectionReversesTheOrientation) {
  onEveryFamily([](const Circles& circles, const FamilyInfo&, Random&) {
    Circles mirrored = circles;
    for (Circle& c : mirrored) c.x = -c.x;
    Diagram actual = diagramOf(mirrored);
    for (Vertex& v : actual.vertices) v.x = -v.x;
    for (auto& triple : actual.vertexCircles) std::swap(triple[1], triple[2]);
    for (Edge& edge : actual.edges) std::swap(edge.left, edge.right);
    std::ranges::reverse(actual.hull);
    expectSame(actual, diagramOf(circles), circles);
  });
}

TEST(Metamorphic, RemovingAHiddenCircleChangesNothing) {
  onEveryFamily([](const Circles& circles, const FamilyInfo&, Random& random) {
    Diagram expected = diagramOf(circles);
    if (expected.hidden.empty()) return;
    const std::size_t place = random.below(expected.hidden.size());
    const std::int32_t removed = expected.hidden[place].circle;
    Circles fewer = circles;
    fewer.erase(fewer.begin() + removed);
    std::vector<std::int32_t> names(fewer.size());
    for (std::size_t i = 0; i < names.size(); ++i)
      names[i] = static_cast<std::int32_t>(i) + (static_cast<std::int32_t>(i) >= removed ? 1 : 0);
    expected.hidden.erase(expected.hidden.begin() + static_cast<std::ptrdiff_t>(place));
    EXPECT_EQ(test::differenceAfterMerging(test::renamed(diagramOf(fewer), names), expected, circles), "");
  });
}

TEST(Metamorphic, MethodsAgree) {
  onEveryFamily([](const Circles& circles, const FamilyInfo&, Random&) {
    const Diagram expected = diagramOf(circles);
    Options options;
    options.method = Method::touchingDisc;
    options.candidates = Candidates::allPairs;
    const Diagram actual = compute(circles, options).value();
    if (actual.certificate.certified()) expectSame(actual, expected, circles);
  });
}

/// The diagram whose dual is the Delaunay triangulation of the centers, without coordinates.
Diagram delaunayDiagram(const Circles& circles) {
  std::vector<Point> centers;
  for (const Circle& c : circles) centers.push_back({c.x, c.y});
  const Delaunay triangulation = delaunay(centers);
  Diagram diagram;
  std::vector<std::int32_t> vertexOf;
  const Dual& dual = triangulation.dual;
  for (int face = 0; face < dual.faceCount(); ++face) {
    vertexOf.push_back(dual.isFinite(face) ? static_cast<std::int32_t>(diagram.vertexCircles.size()) : kNone);
    if (!dual.isFinite(face)) continue;
    diagram.vertexCircles.push_back({dual.origin[3 * face], dual.origin[3 * face + 1], dual.origin[3 * face + 2]});
  }
  for (int h = 0; h < dual.halfEdgeCount(); ++h) {
    const int t = dual.twin[h];
    if (h > t || dual.origin[h] == kPointAtInfinity || dual.origin[t] == kPointAtInfinity) continue;
    diagram.edges.push_back({dual.origin[h], dual.origin[t], vertexOf[t / 3], vertexOf[h / 3]});
  }
  for (std::size_t i = 0; i < circles.size(); ++i) {
    const auto representative = static_cast<std::int32_t>(triangulation.representative[i]);
    if (representative != static_cast<std::int32_t>(i))
      diagram.hidden.push_back({static_cast<std::int32_t>(i), representative});
  }
  return diagram;
}

/// Circles of one radius on the centers of a family, each center once.
Circles equalOnes(const Circles& circles, double r) {
  std::set<std::pair<double, double>> seen;
  Circles equal;
  for (const Circle& c : circles) {
    if (seen.insert({c.x, c.y}).second) equal.push_back({c.x, c.y, r});
  }
  return equal;
}

TEST(Metamorphic, EqualRadiiAndPointsGiveTheDelaunayTriangulation) {
  onEveryFamily([](const Circles& circles, const FamilyInfo&, Random& random) {
    for (const double r : {0.0, 0x1p-10, std::floor(random.uniform(0, 0x1p20)) * 0x1p-10}) {
      const Circles equal = equalOnes(circles, r);
      EXPECT_EQ(test::differenceAfterMerging(diagramOf(equal), delaunayDiagram(equal), equal), "");
    }
  });
}

}  // namespace
}  // namespace circle_voronoi
