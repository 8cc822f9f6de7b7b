// SPDX-License-Identifier: GPL-3.0-or-later
// Additive weights of any sign: radii that count by their differences alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "circle_voronoi/cells.h"
#include "circle_voronoi/certify.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/editor.h"
#include "circle_voronoi/export.h"
#include "circle_voronoi/final_cells.h"
#include "circle_voronoi/finder.h"
#include "circle_voronoi/hull.h"
#include "circle_voronoi/io.h"
#include "circle_voronoi/merged.h"
#include "circle_voronoi/queries.h"
#include "circle_voronoi/tile.h"
#include "circle_voronoi_families/families.h"
#include "compare.h"
#include "oracle.h"
#include "random.h"
#include "regions.h"
#include "report.h"
#include "tie_inputs.h"

namespace circle_voronoi {
namespace {

using Circles = std::vector<Circle>;

const Options kWeights = [] {
  Options options;
  options.weights = true;
  return options;
}();
/// Two whose bisector bends around the first, and one that the second hides.
const Circles kNegative = {{0, 0, -3}, {6, 0, -1}, {6.5, 0, -2}};

Circles withMore(Circles circles, double more) {
  for (Circle& c : circles) c.r += more;
  return circles;
}

/// The same topology, and the same bits of all coordinates; radii that differ by the added number, but for rounding.
void expectOnlyRadiiDiffer(const Diagram& actual, const Diagram& expected, double more) {
  EXPECT_EQ(actual.hidden, expected.hidden);
  EXPECT_EQ(actual.hull, expected.hull);
  EXPECT_EQ(actual.vertexCircles, expected.vertexCircles);
  EXPECT_EQ(actual.edges, expected.edges);
  ASSERT_EQ(actual.vertices.size(), expected.vertices.size());
  for (std::size_t v = 0; v < actual.vertices.size(); ++v) {
    const Vertex& vertex = actual.vertices[v];
    const Vertex& other = expected.vertices[v];
    EXPECT_EQ(vertex.x, other.x);
    EXPECT_EQ(vertex.y, other.y);
    EXPECT_NEAR(vertex.r, other.r - more, 0x1p-51 * (std::abs(vertex.r) + std::abs(other.r)));
  }
}

void expectNumberChangesNothing(const Circles& circles, double more) {
  const auto expected = compute(circles);
  const Circles weights = withMore(circles, more);
  const auto actual = compute(weights, kWeights);
  ASSERT_TRUE(expected.ok());
  ASSERT_TRUE(actual.ok()) << actual.error().message;
  EXPECT_TRUE(actual.value().weights);
  expectOnlyRadiiDiffer(actual.value(), expected.value(), more);
  EXPECT_TRUE(certify(actual.value()).value().certified());
}

TEST(Weights, AddingOneNumberToAllChangesNoBitOfAnyFamily) {
  const std::uint64_t seed = test::seedOr(1);
  for (const FamilyInfo& family : families()) {
    for (std::uint64_t trial = 0; trial < 6; ++trial) {
      Random random(seed * 1'000'003 + trial);
      const Circles circles = test::onDyadicGrid(generate(family.family, 2 + random.below(100), random.next()));
      SCOPED_TRACE(std::string(family.name) + ", trial " + std::to_string(trial));
      // Adds -1 times more than all radii, -1 times a part of them, and a positive number.
      for (const double most : {-0x1p30, -0x1p18, 0x1p20}) {
        expectNumberChangesNothing(circles, std::floor(random.uniform(0, most)) * 0x1p-10);
      }
      if (HasFailure()) FAIL() << test::describe(circles);
    }
  }
}

TEST(Weights, AddingOneNumberToAllChangesNoBitOfTies) {
  const std::uint64_t seed = test::seedOr(1);
  for (const test::TieKind& kind : test::tieKinds()) {
    for (std::uint64_t trial = 0; trial < 6; ++trial) {
      Random random(seed * 1'000'003 + trial);
      const Circles circles = kind.make(2 + random.below(60), random);
      SCOPED_TRACE(std::string(kind.name) + ", trial " + std::to_string(trial));
      for (const double most : {-1e6, -20.0}) expectNumberChangesNothing(circles, std::floor(random.uniform(most, 0)));
      if (HasFailure()) FAIL() << test::describe(circles);
    }
  }
}

// Sums of all bits, which round: other circles, with a diagram of their own.
TEST(Weights, OfAnySignHaveTheDiagramOfTheOracle) {
  const std::uint64_t seed = test::seedOr(1);
  for (const FamilyInfo& family : families()) {
    for (std::uint64_t trial = 0; trial < 3; ++trial) {
      Random random(seed * 1'000'003 + trial);
      Circles circles = generate(family.family, 2 + random.below(60), random.next());
      double largest = 0;
      for (const Circle& c : circles) largest = std::max(largest, c.r);
      const double more = -random.uniform(0, 1.5) * (largest > 0 ? largest : 1);
      circles = withMore(circles, more);
      SCOPED_TRACE(std::string(family.name) + ", trial " + std::to_string(trial));
      const auto diagram = compute(circles, kWeights);
      ASSERT_TRUE(diagram.ok()) << diagram.error().message;
      EXPECT_EQ(test::problemInDegeneratePosition(diagram.value(), oracle::exactDiagram(circles), circles), "");
      EXPECT_TRUE(certify(diagram.value()).value().certified());
      if (HasFailure()) FAIL() << test::describe(circles);
    }
  }
}

TEST(Weights, AllMethodsTakeThem) {
  const Circles circles = test::onDyadicGrid(generate(Family::logUniform, 200, 5));
  const Diagram expected = compute(circles).value();
  for (const Method method : {Method::touchingDisc, Method::flip}) {
    for (const Candidates candidates : {Candidates::dynamic, Candidates::uniform, Candidates::allPairs}) {
      Options options = kWeights;
      options.method = method;
      options.candidates = candidates;
      options.resample = candidates == Candidates::dynamic;
      const Diagram actual = compute(withMore(circles, -600), options).value();
      EXPECT_TRUE(actual.certificate.certified()) << actual.certificate.message;
      EXPECT_EQ(test::difference(actual, expected), "");
    }
  }
}

TEST(Weights, WithoutThemANegativeRadiusIsAnError) {
  EXPECT_EQ(compute(kNegative).error().code, ErrorCode::negativeRadius);
  Diagram diagram = compute(kNegative, kWeights).value();
  EXPECT_EQ(diagram.hidden, (std::vector<HiddenCircle>{{2, 1}}));
  diagram.weights = false;
  EXPECT_EQ(certify(diagram).error().code, ErrorCode::negativeRadius);
  const MissingCircles known = {{-100, -100, 100, 100}, 0};
  EXPECT_EQ(finalCells(diagram, known).error().code, ErrorCode::negativeRadius);
  diagram.weights = true;
  EXPECT_TRUE(certify(diagram).value().certified());
  EXPECT_TRUE(finalCells(diagram, known).ok());
  EXPECT_EQ(compute(Circles{{0, 0, -1e29}}, kWeights).error().code, ErrorCode::coordinateTooLarge);
  EXPECT_EQ(compute(Circles{{0, 0, -INFINITY}}, kWeights).error().code, ErrorCode::nonFinite);
  EXPECT_TRUE(compute(Circles{{0, 0, -1e28}, {0, 1, -1e-300}}, kWeights).ok());
}

TEST(Weights, AnEditorTakesThem) {
  const std::uint64_t seed = test::seedOr(1);
  EXPECT_EQ(DiagramEditor::from(kNegative).error().code, ErrorCode::negativeRadius);
  for (const Family family : {Family::uniform, Family::intersecting, Family::hidden, Family::grid}) {
    SCOPED_TRACE(familyName(family));
    Random random(seed);
    Circles circles = generate(family, 120, seed);
    const auto lowered = [](Circle c) { return Circle{c.x, c.y, c.r - 2}; };
    std::ranges::transform(circles, circles.begin(), lowered);
    auto editor = DiagramEditor::from(circles, {true}).value();
    for (const Circle& c : generate(family, 120, seed + 1)) {
      const auto ids = editor.ids();
      const CircleId id = ids[random.below(ids.size())];
      ASSERT_TRUE(editor.insert(lowered(c)));
      ASSERT_TRUE(random.below(2) == 0 ? editor.remove(id) : editor.replace(id, lowered({c.y, c.x, 2 * c.r})));
    }
    const Diagram snapshot = editor.snapshot().value();
    EXPECT_TRUE(snapshot.weights);
    EXPECT_TRUE(certify(snapshot)->certified());
    EXPECT_EQ(test::difference(snapshot, compute(editor.circles(), kWeights).value()), "");
    EXPECT_EQ(editor.insert({0, 0, -INFINITY}).error().code, ErrorCode::nonFinite);
  }
}

// For large radii rounding is that of the radii, not of their differences.
TEST(Weights, LargeOnesRoundNothingElse) {
  const std::uint64_t seed = test::seedOr(1);
  for (std::uint64_t trial = 0; trial < 20; ++trial) {
    Random random(seed * 1'000'003 + trial);
    Circles circles;
    for (int i = 0; i < 40; ++i) {
      circles.push_back({random.uniform(0, 100), random.uniform(0, 100), -0x1p40 - std::floor(random.uniform(0, 20))});
    }
    const Diagram diagram = compute(circles, kWeights).value();
    expectOnlyRadiiDiffer(diagram, compute(withMore(circles, 0x1p41)).value(), -0x1p41);
    const MergedDiagram merged = mergeVertices(diagram);
    EXPECT_LE(merged.vertices.size(), diagram.vertices.size());
  }
}

TEST(Weights, CellsAndNearestCirclesStay) {
  const Circles circles = test::onDyadicGrid(generate(Family::intersecting, 80, 3));
  const Circles weights = withMore(circles, -700);
  const Diagram expected = compute(circles).value();
  const Diagram diagram = compute(weights, kWeights).value();
  const Finder finder(diagram);
  const Finder sameFinder(expected);
  const Region region = test::regionOf(Box{-100, -100, 1100, 1100});
  for (std::int32_t i = 0; i < 80; ++i) {
    EXPECT_EQ(area(outline(diagram, i, region)), area(outline(expected, i, region)));
    const double near = area(outlineWithin(expected, i, 8));
    EXPECT_NEAR(area(outlineWithin(diagram, i, 708)), near, 1e-9 * (1 + near));
  }
  Random random(test::seedOr(1));
  for (int k = 0; k < 200; ++k) {
    const Point p = {random.uniform(-100, 1100), random.uniform(-100, 1100)};
    EXPECT_EQ(finder.find(p), sameFinder.find(p));
  }
  const auto disc = largestEmptyDiscInside(diagram, region).value();
  const auto sameDisc = largestEmptyDiscCenteredIn(expected, region);
  ASSERT_TRUE(disc && sameDisc);
  // 700 more than the circles leave: sides are nearer than circles.
  EXPECT_NEAR(disc->disc.r, 600, 1e-9);
  EXPECT_NEAR(largestEmptyDiscCenteredIn(diagram, region)->disc.r, sameDisc->disc.r + 700, 1e-9);
  EXPECT_NEAR(closestPair(diagram)->gap, closestPair(expected)->gap + 1400, 1e-9);
}

// The hull is that of the circles grown until the least on the hull is a point.
TEST(Weights, TheHullIsOfGrownCircles) {
  Circles circles = test::onDyadicGrid(generate(Family::logUniform, 100, 7));
  const Diagram known = compute(circles).value();
  double least = INFINITY;
  for (const CircleIndex i : known.hull) least = std::min(least, circles[static_cast<std::size_t>(i)].r);
  circles = withMore(circles, -least);
  const Circles weights = withMore(circles, -512);
  const Diagram diagram = compute(weights, kWeights).value();
  const Diagram same = compute(circles, kWeights).value();
  EXPECT_EQ(hullGrowth(same), 0);
  EXPECT_EQ(hullGrowth(diagram), 512);
  const Hull actual = convexHull(diagram);
  const Hull expected = convexHull(same);
  EXPECT_EQ(actual.length, expected.length);
  EXPECT_EQ(actual.area, expected.area);
  for (std::size_t k = 0; k < actual.arcs.size(); ++k) {
    EXPECT_EQ(actual.arcs[k].start, expected.arcs[k].start);
    EXPECT_EQ(actual.arcs[k].r, expected.arcs[k].r);
  }
  const auto disc = largestEmptyDiscCenteredInHull(diagram);
  const auto sameDisc = largestEmptyDiscCenteredInHull(same);
  EXPECT_NEAR(disc->disc.x, sameDisc->disc.x, 1e-9);
  EXPECT_NEAR(disc->disc.r, sameDisc->disc.r + 512, 1e-9);

  const Diagram alone = compute(Circles{{1, 2, -4}}, kWeights).value();
  EXPECT_EQ(convexHull(alone).arcs.at(0).r, 0);
  EXPECT_EQ(largestEmptyDiscCenteredInHull(alone)->disc.r, 4);
}

TEST(Weights, FilesSayThatTheyAre) {
  const Diagram diagram = compute(kNegative, kWeights).value();
  std::ostringstream out;
  EXPECT_TRUE(writeJson(out, diagram));
  const std::string text = out.str();
  EXPECT_NE(text.find("\"weights\": true"), std::string::npos);
  const auto read = readDiagram(text, "file");
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(read.value().circles, kNegative);
  EXPECT_TRUE(read.value().weights);
  EXPECT_TRUE(certify(read.value()).value().certified());

  const auto errorAfter = [&](const std::string& written) {
    std::string changed = text;
    changed.replace(changed.find("true"), 4, written);
    return readDiagram(changed, "file").error().message;
  };
  EXPECT_EQ(errorAfter("false"), "file:4: Circle 0 has a negative radius.");
  EXPECT_EQ(errorAfter("1"), "file:2: expected true or false for weights, not a number.");
  EXPECT_EQ(errorAfter("true, \"weights\": false"), "file:4: Circle 0 has a negative radius.");

  std::ostringstream plain;
  EXPECT_TRUE(writeJson(plain, compute(Circles{{0, 0, 1}}).value()));
  EXPECT_EQ(plain.str().find("weights"), std::string::npos);
  EXPECT_FALSE(readDiagram(plain.str(), "file").value().weights);

  const std::string table = "0,0,-3\n6,0,-1\n6.5,0,-2\n";
  EXPECT_EQ(readCircles(table, "file").error().message, "file:1: Circle 0 has a negative radius.");
  EXPECT_EQ(readCircles(table, "file", {.weights = true}).value(), kNegative);
  EXPECT_EQ(readTile(table, "file").error().code, ErrorCode::negativeRadius);
  EXPECT_EQ(readTile(table, "file", {.weights = true}).value().circles, kNegative);
}

// A circle of negative radius has its center to show.
TEST(Weights, NegativeOnesAreDrawnAsPoints) {
  const Diagram diagram = compute(kNegative, kWeights).value();
  std::ostringstream svg;
  EXPECT_TRUE(writeSvg(svg, diagram));
  const std::string text = svg.str();
  EXPECT_NE(text.find("data-circle=\"0\" class=\"point\" d=\"M0 0h0\""), std::string::npos) << text;
  EXPECT_EQ(text.find("r=\"-"), std::string::npos);
  EXPECT_EQ(text.find("A-"), std::string::npos);
  SvgFigure figure;
  figure.groups = {"hull"};
  for (const std::vector<Circle>& circles : {kNegative, Circles{{1, 2, -3}}}) {
    std::ostringstream hull;
    EXPECT_TRUE(writeSvgFigure(hull, compute(circles, kWeights).value(), figure));
    EXPECT_NE(hull.str().find("class=\"hull\""), std::string::npos);
    EXPECT_EQ(hull.str().find("r=\"-"), std::string::npos) << hull.str();
    EXPECT_EQ(hull.str().find("A-"), std::string::npos) << hull.str();
  }
  const Box box = exportBox(kNegative);
  EXPECT_NEAR(box.minX, -0.325, 1e-15);
  EXPECT_NEAR(box.maxY, 0.325, 1e-15);
}

}  // namespace
}  // namespace circle_voronoi
