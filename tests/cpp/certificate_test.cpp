// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "circle_voronoi/certify.h"
#include "circle_voronoi/compute.h"
#include "diagrams.h"
#include "dual_edits.h"

namespace circle_voronoi {
namespace {

const std::vector<Circle> kSquare = {{0, 0, 1}, {9, 1, 2}, {10, 10, 1}, {1, 9, 2}};
/// The first hides the last.
const std::vector<Circle> kNested = {{9, 9, 9}, {0, 10, 2}, {11, 6, 5}};

using test::diagramOf;

/// The certificate of a diagram for its own circles or for others.
Certificate judged(std::span<const Circle> circles, Diagram diagram) {
  diagram.circles.assign(circles.begin(), circles.end());
  linkSides(diagram);
  return certify(diagram).value();
}

TEST(Certificate, CertifiesFewCircles) {
  const std::vector<Circle> row = {{0, 0, 1}, {4, 0, 1}, {8, 0, 1}, {12, 0, 1}};
  for (std::size_t count = 0; count <= row.size(); ++count) {
    const auto circles = std::span(row).first(count);
    EXPECT_EQ(judged(circles, diagramOf(circles)).flaw, Flaw::none) << count;
  }
  EXPECT_EQ(judged(kSquare, diagramOf(kSquare)).flaw, Flaw::none);
  EXPECT_EQ(judged(kNested, diagramOf(kNested)).flaw, Flaw::none);
}

TEST(Certificate, RefusesTheDiagramOfFewerOrMoreCircles) {
  for (std::size_t count = 0; count < kSquare.size(); ++count) {
    const auto fewer = std::span(kSquare).first(count);
    EXPECT_FALSE(judged(kSquare, diagramOf(fewer)).certified()) << count;
    EXPECT_FALSE(judged(fewer, diagramOf(kSquare)).certified()) << count;
  }
}

TEST(Certificate, NamesTheEdgeThatIsOutOfOrder) {
  Diagram diagram = diagramOf(kSquare);
  Dual dual = test::dualOf(diagram, kSquare.size());
  int h = 0;
  while (!dual.isFinite(h / 3) || !dual.isFinite(dual.twin[h] / 3)) ++h;
  dual.flip(h);
  test::replaceTopology(diagram, dual, kSquare);
  const Certificate certificate = judged(kSquare, diagram);
  EXPECT_EQ(certificate.flaw, Flaw::edgeOutOfOrder);
  ASSERT_NE(certificate.edge, kNone);
  const Edge& edge = diagram.edges[static_cast<std::size_t>(certificate.edge)];
  EXPECT_NE(edge.start, kNone);
  EXPECT_NE(edge.end, kNone);
  EXPECT_NE(certificate.message.find("Edge " + std::to_string(certificate.edge)), std::string::npos);
}

TEST(Certificate, NamesTheVertexThatIsElsewhere) {
  Diagram diagram = diagramOf(kSquare);
  diagram.vertices[1].y += 1e-6;
  const Certificate certificate = judged(kSquare, diagram);
  EXPECT_EQ(certificate.flaw, Flaw::vertexMisplaced);
  EXPECT_EQ(certificate.vertex, 1);
}

// It touches the same three circles, but clockwise.
TEST(Certificate, RefusesTheDiscOnTheOtherSide) {
  const std::vector<Circle> circles = {{-5, 0, 4}, {5, 0, 4}, {0, 0, 0.1}};
  Diagram diagram = diagramOf(circles);
  ASSERT_EQ(diagram.vertices.size(), 2U);
  EXPECT_EQ(judged(circles, diagram).flaw, Flaw::none);
  std::swap(diagram.vertices[0], diagram.vertices[1]);
  EXPECT_EQ(judged(circles, diagram).flaw, Flaw::vertexMisplaced);
}

TEST(Certificate, AcceptsVerticesRoundedOtherwise) {
  Diagram diagram = diagramOf(kSquare);
  for (Vertex& v : diagram.vertices) {
    v.x = std::nextafter(v.x, 100);
    v.y = std::nextafter(v.y, -100);
    v.r = std::nextafter(v.r, 100);
  }
  EXPECT_EQ(judged(kSquare, diagram).flaw, Flaw::none);
}

TEST(Certificate, NamesTheCircleThatIsNotHidden) {
  Diagram diagram = diagramOf(kNested);
  ASSERT_EQ(diagram.hidden, (std::vector<HiddenCircle>{{2, 0}}));
  diagram.hidden[0].by = 1;
  const Certificate certificate = judged(kNested, diagram);
  EXPECT_EQ(certificate.flaw, Flaw::hiddenWithoutHider);
  EXPECT_EQ(certificate.circle, 2);
}

TEST(Certificate, RefusesACellForAHiddenCircle) {
  // The hidden circle gets two edges, with its hider and with the point at infinity. No sign that the judge looks at is
  // wrong, but without a tangent line of the two circles the signs mean nothing.
  Diagram diagram = diagramOf(kNested);
  diagram.hidden.clear();
  Dual dual = test::dualOf(diagram, kNested.size());
  for (int h = 0; h < dual.halfEdgeCount(); ++h) {
    Dual withCell = dual;
    test::insertOnEdge(withCell, h, 2);
    test::replaceTopology(diagram, withCell, kNested);
    const Certificate certificate = judged(kNested, diagram);
    EXPECT_FALSE(certificate.certified());
    if (dual.origin[h] == 0 || dual.target(h) == 0) {
      EXPECT_EQ(certificate.flaw, Flaw::cellNotClosed);
      EXPECT_EQ(certificate.circle, 2);
    }
  }
}

TEST(Certificate, NamesCirclesByTheirIndicesAmongAllCircles) {
  // The first circle is hidden by the second.
  std::vector<Circle> circles = kNested;
  circles.insert(circles.begin(), {9, 9, 0.5});
  const auto behind = [&](Diagram diagram) {
    for (auto& triple : diagram.vertexCircles) {
      for (CircleIndex& i : triple) ++i;
    }
    for (Edge& edge : diagram.edges) edge = {edge.left + 1, edge.right + 1, edge.start, edge.end};
    for (CircleIndex& i : diagram.hull) ++i;
    diagram.hidden.insert(diagram.hidden.begin(), {0, 1});
    return judged(circles, diagram);
  };
  Diagram diagram = diagramOf(kNested);
  diagram.hidden.clear();
  Dual dual = test::dualOf(diagram, kNested.size());
  test::insertOnEdge(dual, 0, 2);
  test::replaceTopology(diagram, dual, kNested);
  const Certificate certificate = behind(diagram);
  EXPECT_EQ(certificate.flaw, Flaw::cellNotClosed);
  EXPECT_EQ(certificate.circle, 3);
  EXPECT_EQ(certificate.message, "Circle 3 has a cell that does not go around it exactly once.");
  diagram.hull.push_back(diagram.hull.front());
  const Certificate repeated = behind(diagram);
  EXPECT_EQ(repeated.flaw, Flaw::badIndex);
  EXPECT_EQ(repeated.circle, diagram.hull.front() + 1);
}

TEST(Certificate, OneOfIdenticalCirclesIsHiddenByTheOther) {
  const std::vector<Circle> circles = {{0, 0, 1}, {0, 0, 1}, {5, 0, 1}};
  Diagram diagram = diagramOf(circles);
  EXPECT_EQ(diagram.hidden, (std::vector<HiddenCircle>{{1, 0}}));
  EXPECT_TRUE(judged(circles, diagram).certified());
  diagram.hidden = {{1, 0}, {0, 1}};
  EXPECT_EQ(judged(circles, diagram).flaw, Flaw::hiddenWithoutHider);
}

TEST(Certificate, OfCentersLooksAtNoRadii) {
  const std::vector<Circle> circles = {{0, 0, 5}, {4, 0, 1}, {0, 9, 7}, {3, 3, 0}};
  const Diagram centers = compute(circles, {.metric = Metric::centers}).value();
  EXPECT_EQ(centers.circles, circles);
  EXPECT_TRUE(certify(centers).value().certified());
  Diagram other = centers;
  other.metric = Metric::circles;
  EXPECT_FALSE(certify(other).value().certified());
}

TEST(Certificate, RejectsBadCircles) {
  Diagram diagram;
  diagram.circles = {{0, std::nan(""), 1}};
  const auto certificate = certify(diagram);
  ASSERT_FALSE(certificate.ok());
  EXPECT_EQ(certificate.error().code, ErrorCode::nonFinite);
}

}  // namespace
}  // namespace circle_voronoi
