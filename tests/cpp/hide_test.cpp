// SPDX-License-Identifier: GPL-3.0-or-later
// Hidden circles against the definition: every pair, in integers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "brute_force.h"
#include "circle_voronoi/certify.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi_families/families.h"
#include "found_sites.h"
#include "judge.h"
#include "random.h"
#include "report.h"
#include "tie_inputs.h"
#include "triangulate.h"
#include "validate.h"
#include "variants.h"

namespace circle_voronoi {
namespace {

void check(const std::vector<Circle>& circles, const std::string& what) {
  const std::vector<HiddenCircle> expected = test::hiddenByDefinition(circles);
  // By a search, and where it gives up at once by insertion.
  for (const std::int64_t mostSteps : {kMostStepsACircle, std::int64_t{-1000}}) {
    const Sites visible = test::foundSites(order(circles), Threads(), mostSteps).sites;
    ASSERT_EQ(visible.hidden, expected) << what << test::describe(circles);
    EXPECT_EQ(visible.circles.size() + visible.hidden.size(), circles.size());
    for (std::size_t i = 0; i < visible.circles.size(); ++i) {
      EXPECT_EQ(visible.circles[i], circles[visible.indices[i]]);
    }
  }
}

TEST(Hide, NamesTheLargestAndThenTheFirstInEveryFamily) {
  const std::uint64_t seed = test::seedOr(1);
  for (const FamilyInfo& family : families()) {
    for (const std::size_t count : {1, 2, 7, 8, 9, 64, 65, 300}) {
      check(validate(generate(family.family, count, seed)).value(),
            std::string(family.name) + ", seed " + std::to_string(seed));
    }
  }
}

TEST(Hide, IsExactInAndNearTies) {
  const std::uint64_t seed = test::seedOr(1);
  test::forEachTie(seed, 140, [&](const std::vector<Circle>& circles, std::string_view kind) {
    const auto rounded = validate(circles);
    // One circle may be tiny, and the other the origin.
    if (!rounded && rounded.error().code == ErrorCode::coordinateTooSmall) return;
    ASSERT_TRUE(rounded.ok());
    check(rounded.value(), std::string(kind) + ", seed " + std::to_string(seed));
  });
}

TEST(Hide, IsExactWhereSquaresUnderflow) {
  const std::uint64_t seed = test::seedOr(1);
  Random random(seed);
  for (const FamilyInfo& family : families()) {
    for (int trial = 0; trial < 8; ++trial) {
      const auto circles = test::besideFarPoint(generate(family.family, 2 + random.below(40), random.next()), random);
      check(validate(circles).value(), std::string(family.name) + ", seed " + std::to_string(seed));
    }
  }
}

TEST(Hide, IsExactWhereSlacksUnderflow) {
  const std::uint64_t seed = test::seedOr(1);
  Random random(seed);
  for (int trial = 0; trial < 2000; ++trial) {
    const auto circles = test::nestedTightly(2 + random.below(8), random);
    check(validate(circles).value(), "seed " + std::to_string(seed));
    const auto diagram = compute(circles);
    ASSERT_TRUE(diagram.ok()) << diagram.error().message << test::describe(circles);
    EXPECT_TRUE(certify(diagram.value()).value().certified()) << test::describe(circles);
  }
}

TEST(Hide, OfManyCopiesTheFirstHidesAll) { check(std::vector<Circle>(1000, {1, 2, 3}), "copies"); }

TEST(Hide, OfEqualCirclesTheFirstIsNamed) {
  // All other circles contain the last one, and no other pair is nested.
  std::vector<Circle> circles;
  for (int i = 99; i >= 0; --i) circles.push_back({static_cast<double>(i), 0, 1000});
  circles.push_back({50, 0, 1});
  check(circles, "equal");
  EXPECT_EQ(test::foundSites(order(circles)).sites.hidden, (std::vector<HiddenCircle>{{100, 0}}));
}

TEST(Hide, InsertionLeavesTheDiagramOfTheVisibleCircles) {
  const std::uint64_t seed = test::seedOr(1);
  for (const FamilyInfo& family : families()) {
    const auto circles = validate(generate(family.family, 500, seed)).value();
    const auto [visible, inserted] = test::foundSites(order(circles), Threads(), -1000);
    if (!visible.centers.origin.empty()) continue;  // the triangulation has shown that none is hidden
    ASSERT_TRUE(inserted) << family.name;
    Predicates predicates(visible.circles);
    EXPECT_TRUE(judge(visible.circles, inserted->dual, predicates).isRight()) << family.name;
  }
}

TEST(Hide, TakesNLogNSteps) {
  const std::uint64_t seed = test::seedOr(1);
  for (const FamilyInfo& family : families()) {
    for (const Variant& variant : variants()) {
      const auto steps = [&](std::size_t count) {
        return test::foundSites(order(validate(variant.make(family.family, count, seed)).value())).sites.steps;
      };
      const std::string name = std::string(family.name) + std::string(variant.name) + ", seed " + std::to_string(seed);
      const auto few = static_cast<double>(steps(1'000));
      const auto many = static_cast<double>(steps(16'000));
      // If n grows by a factor of 16, n log n grows by a factor of 22, and n^1.5 would grow by a factor of 64.
      EXPECT_LE(many, 56 * few + 1000) << name;
      EXPECT_LE(many, 150 * 16'000) << name;
    }
  }
}

TEST(Hide, TheTriangulationIsThatOfTheVisibleCenters) {
  for (const Family family : {Family::uniform, Family::hidden, Family::duplicates, Family::chaos}) {
    const Sites sites = triangulate(test::foundSites(order(validate(generate(family, 500, 1)).value())).sites);
    const int count = static_cast<int>(sites.circles.size());
    EXPECT_EQ(sites.centers.faceCount(), count < 2 ? 0 : 2 * count - 2) << familyName(family);
  }
}

// Neighbors along the curve look clear of one another although a circle farther along is hidden.
TEST(Hide, ATriangulationWithHiddenCentersIsNotKept) {
  Random random(test::seedOr(1));
  int misleading = 0;
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<Circle> circles = {{random.uniform(-30, 30), random.uniform(-30, 30), 10}};
    for (int i = 0; i < 12; ++i) circles.push_back({random.uniform(-30, 30), random.uniform(-30, 30), random.unit()});
    const OrderedCircles ordered = order(circles);
    const Sites sites = test::foundSites(ordered).sites;
    const bool looksClear = std::ranges::adjacent_find(ordered.circles, [](const Circle& a, const Circle& b) {
                              return std::hypot(a.x - b.x, a.y - b.y) <= std::max(a.r, b.r);
                            }) == ordered.circles.end();
    if (looksClear && !sites.hidden.empty()) ++misleading;
    const int count = static_cast<int>(sites.circles.size());
    if (sites.centers.faceCount() > 0) {
      EXPECT_EQ(sites.centers.faceCount(), 2 * count - 2) << test::describe(circles);
    }
  }
  EXPECT_GT(misleading, 20);
}

}  // namespace
}  // namespace circle_voronoi
