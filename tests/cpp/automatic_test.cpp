// SPDX-License-Identifier: GPL-3.0-or-later
// Method::automatic is certified and right on every family; a slice of what `npm run soak` does for as long as one
// likes. CIRCLE_VORONOI_SEED chooses other inputs.
#include <gtest/gtest.h>

#include <iostream>

#include "fixtures.h"
#include "report.h"
#include "tie_inputs.h"
#include "trial.h"

namespace circle_voronoi {
namespace {

TEST(Automatic, IsCertifiedAndExactOnEveryFamily) {
  const std::uint64_t seed = test::seedOr(1);
  test::WayTable table;
  for (const FamilyInfo& family : families()) {
    for (std::uint64_t trial = 0; trial < 25; ++trial) {
      Random random(seed * 1'000'003 + trial);
      const std::size_t count = 3 + random.below(198);
      const auto circles = generate(family.family, count, random.next());
      const auto result = test::tryAutomatic(circles, family.isDegenerate);
      table.add(std::string(family.name), result);
      EXPECT_EQ(result.problem, "") << family.name << ", trial " << trial << test::describe(circles);
    }
  }
  std::cout << table.text();
}

TEST(Automatic, IsCertifiedInAndNearTies) {
  const std::uint64_t seed = test::seedOr(1);
  test::WayTable table;
  test::forEachTie(seed, 140, [&](const std::vector<Circle>& circles, std::string_view kind) {
    const auto result = test::tryCertified(circles);
    table.add(std::string(kind), result);
    EXPECT_EQ(result.problem, "") << kind << test::describe(circles);
  });
  std::cout << table.text();
}

TEST(Automatic, IsCertifiedOnEveryFixture) {
  for (const std::string& name : test::fixtureNames()) {
    EXPECT_EQ(test::tryCertified(test::readFixture(name)).problem, "") << name;
  }
}

}  // namespace
}  // namespace circle_voronoi
