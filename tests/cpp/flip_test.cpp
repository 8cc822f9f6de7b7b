// SPDX-License-Identifier: GPL-3.0-or-later
#include "flip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <vector>

#include "circle_voronoi_families/families.h"
#include "dual_edits.h"
#include "found_sites.h"
#include "judge.h"
#include "order.h"
#include "proof.h"
#include "report.h"
#include "small_duals.h"
#include "three_touch_disc.h"
#include "tie_inputs.h"
#include "triangulate.h"
#include "validate.h"
#include "wrong_faces.h"

namespace circle_voronoi {
namespace {

using test::isRight;
using test::kFamilies;
using test::solve;
using test::visibleCircles;

std::int64_t flipAll(std::span<const Circle> circles, Dual& dual) {
  Predicates predicates(circles);
  FaceDiscs discs(circles, dual, predicates);
  return flip(dual, discs).count;
}

TEST(Flip, RightsRandomFlips) {
  const std::uint64_t seed = test::seedOr(1);
  int broken = 0;
  int righted = 0;
  for (const Family family : {Family::uniform, Family::logUniform, Family::ringVaried, Family::points}) {
    for (std::uint64_t trial = 0; trial < 40; ++trial) {
      Random random(seed * 1'000'003 + trial);
      const auto circles = visibleCircles(family, 5 + random.below(60), random.next());
      Dual dual = *solve(circles);
      test::flipRandomEdges(dual, 1, random);
      if (isRight(circles, dual)) continue;
      ++broken;
      if (flipAll(circles, dual) > 0 && isRight(circles, dual)) ++righted;
    }
  }
  EXPECT_GT(broken, 50);
  EXPECT_GE(righted, broken * 9 / 10);
  std::cout << righted << " of " << broken << " broken duals flipped back\n";
}

// The judge rests on what flips have found, and vertices are read from their discs.
TEST(Flip, LeavesTheProofThatTheJudgeFindsItself) {
  for (const Family family : kFamilies) {
    SCOPED_TRACE(familyName(family));
    FoundSites found = test::foundSites(order(validate(generate(family, 200, 1)).value()));
    const Sites sites = triangulate(std::move(found.sites));
    Dual dual = found.inserted ? found.inserted->dual : sites.centers;
    Predicates predicates(sites.circles);
    FaceDiscs discs(sites.circles, dual, predicates);
    flip(dual, discs);
    const Verdict own = judge(sites.circles, dual, predicates);
    const Verdict given = judge(sites.circles, dual, predicates, discs.takeProof());
    EXPECT_EQ(given.flaw, own.flaw);
    EXPECT_EQ(given.face, own.face);
    EXPECT_EQ(given.halfEdge, own.halfEdge);
    EXPECT_EQ(given.ties, own.ties);
    EXPECT_EQ(given.proof.discs, own.proof.discs);
    EXPECT_EQ(given.proof.halfEdges, own.proof.halfEdges);
    for (int face = 0; face < dual.faceCount() && own.isRight(); ++face) {
      if (!dual.isFinite(face)) continue;
      const FaceDisc& disc = own.proof.discs[static_cast<std::size_t>(face)];
      for (int h = 3 * face; h < 3 * face + 3; ++h) {
        const auto corners = cornersOf(dual, h);
        const auto& [i, j, k] = corners;
        const auto expected = vertexOf(sites.circles[i], sites.circles[j], sites.circles[k]);
        EXPECT_EQ(predicates.vertex(corners, disc), expected);
      }
    }
  }
}

TEST(Flip, KnowsWhichEdgesAreRight) {
  std::int64_t known = 0;
  for (const Family family : kFamilies) {
    SCOPED_TRACE(familyName(family));
    Sites sites = triangulate(test::foundSites(order(validate(generate(family, 200, 2)).value())).sites);
    Dual& dual = sites.centers;
    Predicates predicates(sites.circles);
    FaceDiscs discs(sites.circles, dual, predicates);
    flip(dual, discs);
    for (int h = 0; h < dual.halfEdgeCount(); ++h) {
      EXPECT_EQ(discs.isKnownRight(h), discs.flawOf(h) == Flaw::none);
      known += discs.isKnownRight(h);
    }
  }
  EXPECT_GT(known, 5000);
}

TEST(Flip, LeavesTheProofOfChangedFacesToTheJudge) {
  Sites sites = triangulate(test::foundSites(order(validate(generate(Family::logUniform, 200, 2)).value())).sites);
  Dual& dual = sites.centers;
  const Dual before = dual;
  Predicates predicates(sites.circles);
  FaceDiscs discs(sites.circles, dual, predicates);
  flip(dual, discs);
  const auto isChanged = [&](int face) { return cornersOf(dual, 3 * face) != cornersOf(before, 3 * face); };
  int changed = 0;
  for (int face = 0; face < dual.faceCount(); ++face) {
    if (!isChanged(face)) continue;
    discs.set(face, predicates.disc(cornersOf(before, 0)));  // as if a flip had not updated it
    ++changed;
  }
  ASSERT_GT(changed, 20);
  const Proof proof = discs.takeProof();
  for (int face = 0; face < dual.faceCount(); ++face) {
    EXPECT_TRUE(!isChanged(face) || !proof.discs[static_cast<std::size_t>(face)].exists);
  }
  const Verdict own = judge(sites.circles, dual, predicates);
  const Verdict given = judge(sites.circles, dual, predicates, proof);
  EXPECT_TRUE(given.isRight());
  EXPECT_EQ(given.proof.discs, own.proof.discs);
  EXPECT_EQ(given.proof.halfEdges, own.proof.halfEdges);
}

// Where two faces have the same corner opposite their edge, the flipped edge would go from that corner to itself.
TEST(Flip, MakesNoEdgeFromACircleToItself) {
  const std::uint64_t seed = test::seedOr(1);
  for (std::uint64_t trial = 0; trial < 500; ++trial) {
    Random random(seed * 1'000'003 + trial);
    const auto circles = visibleCircles(Family::logUniform, 4 + random.below(4), random.next());
    Dual dual = *solve(circles);
    test::flipRandomEdges(dual, 8, random);
    flipAll(circles, dual);
    for (int h = 0; h < dual.halfEdgeCount(); ++h) ASSERT_NE(dual.origin[h], dual.target(h)) << "trial " << trial;
  }
}

TEST(Flip, DoesNothingToARightDual) {
  for (const Family family : kFamilies) {
    const auto circles = visibleCircles(family, 40, 3);
    Dual dual = *solve(circles);
    EXPECT_EQ(flipAll(circles, dual), 0) << familyName(family);
  }
}

/// Flips from the triangulation of the centers, as for a diagram. They tell of all wrong faces, and keep the discs.
Flips flipFromCenters(const std::vector<Circle>& circles) {
  Sites sites = triangulate(test::foundSites(order(validate(circles).value())).sites);
  Predicates predicates(sites.circles);
  FaceDiscs discs(sites.circles, sites.centers, predicates);
  Flips flips = flip(sites.centers, discs);
  EXPECT_EQ(flips.wrong, wrongFaces(FaceDiscs(sites.circles, sites.centers, predicates)));
  return flips;
}

TEST(Flip, TellsWhereTheDualIsWrong) {
  const std::uint64_t seed = test::seedOr(1);
  int wrong = 0;
  test::forEachTie(seed, 60, [&](const std::vector<Circle>& circles, std::string_view kind) {
    SCOPED_TRACE(test::describe(circles));
    SCOPED_TRACE(kind);
    wrong += !flipFromCenters(circles).wrong.empty();
  });
  EXPECT_GT(wrong, 5);
  std::cout << wrong << " left wrong\n";
}

// Edges whose flips would never end: an edge and its replacement, and a longer cycle. All other edges are flipped.
TEST(Flip, EndsWhereItWouldGoRoundInCircles) {
  for (const std::uint64_t seed : {39, 398}) {
    const Flips flips = flipFromCenters(generate(Family::oneHuge, 1000, seed));
    EXPECT_LT(flips.count, 1100);
    EXPECT_GT(flips.wrong.size(), 0U);
    EXPECT_LT(flips.wrong.size(), 5U);
  }
}

class NoWatcher final : public FaceWatcher {
 public:
  void willChange(int) override {}
};

// A circle grows, and its cell with it, by far more flips than a few wrong edges are granted. The edge at which the
// flips stop is as wrong as the edges that still wait, and often the only wrong edge of its faces.
TEST(Flip, TellsOfEveryWrongFaceWhereItStopsAtItsLimit) {
  const std::uint64_t seed = test::seedOr(1);
  for (std::uint64_t trial = 0; trial < 3; ++trial) {
    SCOPED_TRACE(trial);
    Random random(seed * 1'000'003 + trial);
    std::vector<Circle> circles = {{0, 0, 0}};
    while (circles.size() < 1200) {
      const Circle c = {22 * random.unit() - 11, 22 * random.unit() - 11, 0};
      const double distance = std::hypot(c.x, c.y);
      if (distance > 10 && distance < 10.2) circles.push_back(c);
    }
    Dual dual = *solve(circles);
    circles[0].r = 9.99;
    Predicates predicates(circles);
    FaceDiscs discs(circles, dual, predicates);
    std::vector<int> edges;
    for (int h = 0; h < dual.halfEdgeCount(); ++h) {
      if (h < dual.twin[h] && discs.flawOf(h) != Flaw::none) edges.push_back(h);
    }
    NoWatcher watcher;
    const Flips flips = flipFrom(dual, discs, edges, watcher);
    EXPECT_EQ(flips.count, 100 + 4 * static_cast<std::int64_t>(edges.size()));
    EXPECT_EQ(flips.wrong, wrongFaces(discs));
  }
}

}  // namespace
}  // namespace circle_voronoi
