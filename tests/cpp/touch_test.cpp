// SPDX-License-Identifier: GPL-3.0-or-later
// The rules in which this implementation of the touching disc method differs from the paper's Algorithms 1 to 4, each
// on the smallest input that needs it.
#include "touch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "circle_voronoi/compute.h"
#include "compare.h"
#include "fixtures.h"
#include "oracle.h"

namespace circle_voronoi {
namespace {

struct Solved {
  std::vector<Circle> circles;
  Diagram diagram;
  std::map<TraceKind, int> events;
  std::string problem;
};

Solved solve(const std::vector<Circle>& circles, Options options) {
  Solved solved;
  solved.circles = circles;
  options.method = Method::touchingDisc;
  options.observer = [&](const TraceEvent& event) { ++solved.events[event.kind]; };
  solved.diagram = compute(circles, options).value();
  solved.problem = test::problemInGeneralPosition(solved.diagram, oracle::exactDiagram(circles), circles);
  return solved;
}

Solved solveAllPairs(const std::string& fixture) {
  Options options;
  options.candidates = Candidates::allPairs;
  return solve(test::readFixture(fixture), options);
}

Solved solveSampled(const std::string& fixture, int samples) {
  Options options;
  options.samples = samples;
  return solve(test::readFixture(fixture), options);
}

// The paper finds hidden circles by the leftover DEs. Left in, they take part in antipodal discs and displace the
// neighbors of the circle that contains them: here a copy of circle 0.
TEST(TouchRules, Rule1HiddenCirclesAreRemovedFirst) {
  const Solved solved = solveSampled("missed-antipodal-disc-duplicates-4", 0);
  EXPECT_EQ(solved.problem, "");
  ASSERT_EQ(solved.diagram.hidden.size(), 1U);
  EXPECT_EQ(solved.diagram.hidden[0].circle, 3);
  EXPECT_EQ(solved.diagram.hidden[0].by, 0);
}

// DE(c,a) may exist and belong to another branch of the bisector of c and a: taking it for the third DE of the disc,
// as Algorithm 3 does, closes the diagram of three circles in a row after one vertex.
TEST(TouchRules, Rule2TheThirdDirectedEdgeMustBeAdjacentAndForward) {
  for (const std::string name : {"collinear-varied", "log-uniform", "one-huge", "two-huge"}) {
    const Solved solved = solveAllPairs("third-edge-not-forward-" + name + "-3");
    EXPECT_EQ(solved.problem, "") << name;
    EXPECT_EQ(solved.diagram.vertices.size(), 2U) << name;
  }
}

// Where a disc of R_min is not antipodal, a center to the right of its DE may lie behind it on the bisector.
TEST(TouchRules, Rule3ForwardIsAlongTheBisector) {
  for (const std::string name : {"intersecting-3", "lightly-intersecting-3", "lightly-intersecting-4", "hidden-3"}) {
    EXPECT_EQ(solveAllPairs("center-right-of-edge-" + name).problem, "") << name;
  }
}

// When its turn comes a three-touch disc may name a DE that is gone. Discs are discarded then, and none is lost: the DE
// that took its place has formed its own.
TEST(TouchRules, Rule4DiscsOfDeletedEdgesAreStale) {
  const Solved solved = solveSampled("missed-antipodal-disc-duplicates-22", 1);
  EXPECT_EQ(solved.problem, "");
  EXPECT_GT(solved.events.at(TraceKind::threeTouchDiscStale), 0);
  EXPECT_EQ(solved.events.at(TraceKind::branchDisc), static_cast<int>(solved.diagram.vertices.size()));
}

// All circles touch one disc. A DE sorted into the ring by an angle that rounding has changed would cross another one;
// it takes the places of the two that it replaces.
TEST(TouchRules, Rule5TiesKeepTheOrderOfTheRing) {
  for (const std::string name : {"tie-on-one-disc-cocircular-equal-4", "tie-on-one-disc-cocircular-varied-4",
                                 "center-right-of-edge-cocircular-varied-5"}) {
    const Solved solved = solveAllPairs(name);
    EXPECT_EQ(test::problemInDegeneratePosition(solved.diagram, oracle::exactDiagram(solved.circles), solved.circles),
              "")
        << name;
  }
}

// Opposite circles around one disc all have it for antipodal disc. An antipodal disc that touches a neighbor, but for
// rounding, is left to the three-touch discs; two that were both accepted would cross.
TEST(TouchRules, Rule5AnAntipodalDiscThatTouchesANeighborIsNotEmpty) {
  const Solved solved = solveAllPairs("tie-of-antipodal-disc-cocircular-equal-8");
  EXPECT_EQ(test::problemInDegeneratePosition(solved.diagram, oracle::exactDiagram(solved.circles), solved.circles),
            "");
  EXPECT_EQ(solved.diagram.vertices.size(), 6U);
  EXPECT_EQ(solved.diagram.stats.counts.leftoverCycles, 1);
}

// The antipodal disc of two intersecting circles has a negative radius and may meet a third one like any other.
TEST(TouchRules, Rule6DiscsOfIntersectingCirclesAreTestedForEmptiness) {
  for (const std::string name : {"center-right-of-edge-intersecting-4", "missed-antipodal-disc-intersecting-5",
                                 "missed-antipodal-disc-intersecting-6"}) {
    const Solved solved = solveAllPairs(name);
    EXPECT_EQ(solved.problem, "") << name;
    EXPECT_GT(solved.events.count(TraceKind::antipodalDiscNotEmpty) + solved.events.count(TraceKind::antipodalDiscUsed),
              0U)
        << name;
  }
}

// Each edge has two segments that end in a vertex or at infinity. A DE that goes without a vertex would leave an edge
// behind that nothing joins.
TEST(TouchRules, Rule7EveryEdgeHasItsVertices) {
  for (const std::string& name : test::fixtureNames()) {
    const Solved solved = solveAllPairs(name);
    const auto ends = std::ranges::count_if(solved.diagram.edges, [](const Edge& e) { return e.start != kNone; }) +
                      std::ranges::count_if(solved.diagram.edges, [](const Edge& e) { return e.end != kNone; });
    EXPECT_EQ(ends, 3 * static_cast<std::ptrdiff_t>(solved.diagram.vertices.size())) << name;
  }
}

// Rule 8, which samples there are, has its tests in sample_test.cpp and pair_test.cpp.

// Sampling may miss an antipodal disc; with every pair as a candidate nothing is missing.
TEST(TouchRules, Rule9AllPairsMissNothing) {
  for (const std::string name : {"clustered-4", "log-uniform-4", "mixed-4", "one-huge-4"}) {
    EXPECT_NE(solveSampled("missed-antipodal-disc-" + name, 0).problem, "") << name;
    EXPECT_EQ(solveSampled("missed-antipodal-disc-" + name, 1).problem, "") << name;
    EXPECT_EQ(solveAllPairs("missed-antipodal-disc-" + name).problem, "") << name;
  }
}

// A three-touch disc may come before the antipodal disc of two of its circles by rounding alone. The DE that it places
// stands for both; a second pair of DEs would count the edge twice.
TEST(TouchRules, ADirectedEdgeStandsForTheAntipodalDiscOfItsCircles) {
  const Solved solved = solveAllPairs("antipodal-disc-after-three-touch-disc-clustered-3");
  EXPECT_EQ(solved.problem, "");
  EXPECT_EQ(solved.diagram.edges.size(), 3U);
}

/// The fate of the antipodal disc of circles 0 and 1.
TraceKind fateOfFirstPair(const std::vector<Circle>& circles) {
  std::optional<TraceKind> fate;
  touch(circles, pairAll(static_cast<int>(circles.size())), [&](const TraceEvent& event) {
    const bool isAntipodal = event.kind == TraceKind::antipodalDiscAccepted ||
                             event.kind == TraceKind::antipodalDiscUsed ||
                             event.kind == TraceKind::antipodalDiscNotEmpty;
    if (isAntipodal && event.circles[0] == 0 && event.circles[1] == 1) fate = event.kind;
  });
  EXPECT_TRUE(fate.has_value());
  return fate.value_or(TraceKind::branchDisc);
}

/// Two circles with the antipodal disc of radius 0.9 around the origin, and a point at a distance `gap` outside it, in
/// a direction that makes an angle with that of the first circle.
std::vector<Circle> pointBeside(double angle, double gap) {
  const double size = 0.9 + gap;
  return {{-1, 0, 0.1}, {1, 0, 0.1}, {-size * std::cos(angle), size * std::sin(angle), 0}};
}

// Rounding is some 2^-52 of the numbers. A disc within a few roundings of a neighbor counts as touching it. A disc that
// is some hundred roundings away does not. A three-touch disc may come first and stand for either.
TEST(Touch, TellsRoundingFromAGap) {
  int touching = 0;
  int free = 0;
  for (int i = 1; i < 400; ++i) {
    const TraceKind tied = fateOfFirstPair(pointBeside(0.007 * i, 0x1p-50));
    EXPECT_NE(tied, TraceKind::antipodalDiscAccepted) << i;
    touching += tied == TraceKind::antipodalDiscNotEmpty;
    const TraceKind apart = fateOfFirstPair(pointBeside(0.007 * i, 0x1p-41));
    EXPECT_NE(apart, TraceKind::antipodalDiscNotEmpty) << i;
    free += apart == TraceKind::antipodalDiscAccepted;
  }
  EXPECT_GT(touching, 100);
  EXPECT_GT(free, 100);
}

TEST(Touch, TellsEveryEvent) {
  const Solved solved = solveAllPairs("spruces");
  const auto count = [&](TraceKind kind) {
    const auto found = solved.events.find(kind);
    return found == solved.events.end() ? 0 : found->second;
  };
  const Counts& counts = solved.diagram.stats.counts;
  const int rejected = count(TraceKind::antipodalDiscUsed) + count(TraceKind::antipodalDiscNotEmpty);
  EXPECT_EQ(count(TraceKind::antipodalDiscAccepted) + rejected, counts.antipodalDiscs);
  EXPECT_EQ(count(TraceKind::threeTouchDiscFormed), counts.threeTouchDiscs);
  EXPECT_EQ(count(TraceKind::branchDisc) + count(TraceKind::threeTouchDiscStale), counts.threeTouchDiscs);
  EXPECT_EQ(counts.events, counts.antipodalDiscs + counts.threeTouchDiscs);
  EXPECT_EQ(count(TraceKind::segmentFinished), count(TraceKind::directedEdgeDeleted));
  // The remaining DEs are the hull.
  EXPECT_EQ(count(TraceKind::directedEdgePlaced) - count(TraceKind::directedEdgeDeleted),
            static_cast<int>(solved.diagram.hull.size()));
}

}  // namespace
}  // namespace circle_voronoi
