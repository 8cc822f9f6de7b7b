// SPDX-License-Identifier: GPL-3.0-or-later
// The oracle that all other tests trust, against the definition of the diagram.
#include "oracle.h"

#include <gtest/gtest.h>

#include "brute_force.h"
#include "circle_voronoi_families/families.h"
#include "compare.h"

namespace circle_voronoi {
namespace {

using test::bruteForceVertices;

/// The oracle's diagram, completed by brute force.
void expectBruteForce(std::span<const Circle> circles) {
  const Diagram exact = oracle::exactDiagram(circles);
  Diagram brute;
  brute.vertexCircles = bruteForceVertices(circles);
  brute.hidden = exact.hidden;
  Diagram finite = exact;
  finite.edges.clear();
  EXPECT_EQ(test::difference(finite, brute), "");
}

TEST(Oracle, AgreesWithBruteForce) {
  for (const Family family : {Family::uniform, Family::logUniform, Family::twoHuge, Family::extreme,
                              Family::lightlyIntersecting, Family::intersecting}) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      SCOPED_TRACE(std::string(familyName(family)) + ", seed " + std::to_string(seed));
      const auto circles = generate(family, 3 + seed % 8, seed);
      if (oracle::exactDiagram(circles).hidden.empty()) expectBruteForce(circles);
    }
  }
}

TEST(Oracle, TwoCirclesShareOneLine) {
  const Diagram diagram = oracle::exactDiagram(std::array{Circle{0, 0, 1}, Circle{3, 0, 1}});
  ASSERT_EQ(diagram.edges.size(), 1U);
  EXPECT_EQ(diagram.edges[0].start, kNone);
  EXPECT_EQ(diagram.edges[0].end, kNone);
}

TEST(Oracle, CollinearCirclesHaveNoVertex) {
  const Diagram diagram = oracle::exactDiagram(std::array{Circle{0, 0, 1}, Circle{3, 0, 1}, Circle{6, 0, 1}});
  EXPECT_TRUE(diagram.vertexCircles.empty());
  EXPECT_EQ(diagram.edges.size(), 2U);
}

TEST(Oracle, OrientsVerticesCounterClockwise) {
  const Diagram diagram = oracle::exactDiagram(std::array{Circle{0, 0, 1}, Circle{4, 0, 1}, Circle{0, 4, 1}});
  Diagram expected;
  expected.vertexCircles = {{0, 1, 2}};
  expected.edges = {{0, 1, kNone, 0}, {1, 2, kNone, 0}, {2, 0, kNone, 0}};
  EXPECT_EQ(test::difference(diagram, expected), "");
}

TEST(Oracle, ContainedCirclesAndCopiesAreHidden) {
  const Diagram diagram =
      oracle::exactDiagram(std::array{Circle{0, 0, 3}, Circle{1, 0, 1}, Circle{9, 0, 1}, Circle{0, 0, 3}});
  ASSERT_EQ(diagram.hidden.size(), 2U);
  EXPECT_EQ(diagram.hidden[0].circle, 1);
  EXPECT_EQ(diagram.hidden[1].circle, 3);
}

}  // namespace
}  // namespace circle_voronoi
