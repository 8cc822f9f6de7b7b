// SPDX-License-Identifier: GPL-3.0-or-later
#include "flip.h"

#include <gtest/gtest.h>

#include <iostream>
#include <vector>

#include "circle_voronoi/families.h"
#include "dual_edits.h"
#include "report.h"
#include "small_duals.h"

namespace circle_voronoi {
namespace {

using test::isRight;
using test::kFamilies;
using test::solve;
using test::visibleCircles;

std::int64_t flipAll(std::span<const Circle> circles, Dual& dual) {
  Predicates predicates(circles);
  FaceDiscs discs(circles, dual, predicates);
  return flip(dual, discs);
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

TEST(Flip, DoesNothingToARightDual) {
  for (const Family family : kFamilies) {
    const auto circles = visibleCircles(family, 40, 3);
    Dual dual = *solve(circles);
    EXPECT_EQ(flipAll(circles, dual), 0) << familyName(family);
  }
}

}  // namespace
}  // namespace circle_voronoi
