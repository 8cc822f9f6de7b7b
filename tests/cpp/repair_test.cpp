// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair.h"

#include <gtest/gtest.h>

#include <array>
#include <iostream>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "apollonius.h"
#include "circle_voronoi/families.h"
#include "dual_edits.h"
#include "flip.h"
#include "hide.h"
#include "judge.h"
#include "pair.h"
#include "report.h"
#include "touch.h"
#include "validate.h"

namespace circle_voronoi {
namespace {

std::vector<Circle> visibleCircles(Family family, std::size_t count, std::uint64_t seed) {
  return hide(order(validate(generate(family, count, seed)).value().circles)).circles;
}

std::optional<Dual> judgedRight(std::span<const Circle> circles, Dual dual) {
  Predicates predicates(circles);
  if (!judge(circles, dual, predicates).isRight()) return std::nullopt;
  return dual;
}

/// The touching disc method on all pairs, and if that is wrong CGAL's graph.
std::optional<Dual> solve(std::span<const Circle> circles) {
  const int n = static_cast<int>(circles.size());
  const auto dual = dualOf(touch(circles, pairAll(n), {}).topology, n);
  if (const auto* touched = std::get_if<Dual>(&dual)) {
    if (auto right = judgedRight(circles, *touched)) return right;
  }
  return judgedRight(circles, apolloniusGraph(circles));
}

bool isRight(std::span<const Circle> circles, const Dual& dual) { return judgedRight(circles, dual).has_value(); }

constexpr std::array kFamilies = {Family::uniform,      Family::logUniform, Family::oneHuge,   Family::extreme,
                                  Family::intersecting, Family::chaos,      Family::ringVaried};

TEST(Repair, LeavesARightDualAlone) {
  for (const Family family : kFamilies) {
    const auto circles = visibleCircles(family, 30, 1);
    const Dual right = *solve(circles);
    Dual dual = right;
    Predicates predicates(circles);
    const auto fail = [](std::span<const Circle>) -> std::optional<Dual> {
      ADD_FAILURE() << "nothing is to be solved";
      return std::nullopt;
    };
    EXPECT_EQ(repair(circles, dual, predicates, 2, fail), 0);
    EXPECT_EQ(dual.origin, right.origin);
    EXPECT_EQ(dual.twin, right.twin);
  }
}

TEST(Repair, RightsWhatRandomFlipsBroke) {
  const std::uint64_t seed = test::seedOr(1);
  int broken = 0;
  int repaired = 0;
  for (const Family family : kFamilies) {
    for (std::uint64_t trial = 0; trial < 60; ++trial) {
      SCOPED_TRACE(std::string(familyName(family)) + ", trial " + std::to_string(trial));
      Random random(seed * 1'000'003 + trial);
      const auto circles = visibleCircles(family, 3 + random.below(60), random.next());
      if (circles.size() < 3) continue;
      Dual dual = *solve(circles);
      test::flipRandomEdges(dual, 1 + static_cast<int>(random.below(8)), random);
      if (isRight(circles, dual)) continue;
      ++broken;
      for (const int reach : {2, 4, 8, 16}) {
        Predicates predicates(circles);
        repair(circles, dual, predicates, reach, solve);
        // Right or wrong, it stays a triangulated sphere.
        const Flaw flaw = judge(circles, dual, predicates).flaw;
        ASSERT_NE(flaw, Flaw::adjacency);
        ASSERT_NE(flaw, Flaw::eulerCount);
      }
      if (isRight(circles, dual)) ++repaired;
    }
  }
  EXPECT_GT(broken, 100);
  // A cell may be wrong where no face and no edge shows it; then another construction takes over.
  std::cout << repaired << " of " << broken << " broken duals repaired\n";
  EXPECT_GE(repaired, broken * 49 / 50);
}

TEST(Repair, LeavesWhatCannotBeSolved) {
  const auto circles = visibleCircles(Family::uniform, 40, 1);
  Dual dual = *solve(circles);
  Random random(1);
  ASSERT_GT(test::flipRandomEdges(dual, 3, random), 0);
  const Dual wrong = dual;
  ASSERT_FALSE(isRight(circles, dual));
  Predicates predicates(circles);
  const auto giveUp = [](std::span<const Circle>) { return std::optional<Dual>(); };
  EXPECT_EQ(repair(circles, dual, predicates, 2, giveUp), 0);
  EXPECT_EQ(dual.origin, wrong.origin);
  EXPECT_EQ(dual.twin, wrong.twin);
}

TEST(Repair, RepairsAtInfinity) {
  // A triangle of points with one on each side, pulled outwards: flip every edge at infinity in turn.
  const std::vector<Circle> circles = {{0, 0, 1}, {10, 0, 2}, {5, 9, 1}, {5, -1, 0.5}, {8, 5, 0.5}, {2, 5, 0.5}};
  const Dual right = *solve(circles);
  int broken = 0;
  for (int h = 0; h < right.halfEdgeCount(); ++h) {
    Dual dual = right;
    const bool isAtInfinity = dual.origin[h] == kInfinity || dual.target(h) == kInfinity || !dual.isFinite(h / 3) ||
                              !dual.isFinite(dual.twin[h] / 3);
    if (!isAtInfinity || dual.origin[Dual::previous(h)] == dual.origin[Dual::previous(dual.twin[h])]) continue;
    test::flipEdge(dual, h);
    if (isRight(circles, dual)) continue;
    ++broken;
    for (const int reach : {2, 4}) {
      Predicates predicates(circles);
      repair(circles, dual, predicates, reach, solve);
    }
    EXPECT_TRUE(isRight(circles, dual)) << h;
  }
  EXPECT_GT(broken, 3);
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
      Predicates predicates(circles);
      if (flip(circles, dual, predicates) > 0 && isRight(circles, dual)) ++righted;
    }
  }
  EXPECT_GT(broken, 50);
  EXPECT_GE(righted, broken * 9 / 10);
  std::cout << righted << " of " << broken << " broken duals flipped back\n";
}

TEST(Flip, DoesNothingToARightDual) {
  for (const Family family : kFamilies) {
    const auto circles = visibleCircles(family, 40, 3);
    Dual dual = *solve(circles);
    Predicates predicates(circles);
    EXPECT_EQ(flip(circles, dual, predicates), 0) << familyName(family);
  }
}

}  // namespace
}  // namespace circle_voronoi
