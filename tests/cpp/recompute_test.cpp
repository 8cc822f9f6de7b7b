// SPDX-License-Identifier: GPL-3.0-or-later
#include "recompute.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "circle_voronoi/certify.h"
#include "circle_voronoi/compute.h"
#include "edit_script.h"
#include "random.h"

namespace circle_voronoi {
namespace {

TEST(Recompute, GivesTheDiagramOfComputeButForNumbers) {
  Random random(61);
  int flipped = 0;
  for (int trial = 0; trial < 60; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    const std::size_t count = 1 + random.below(trial % 2 == 0 ? 8 : 300);
    std::vector<Circle> circles;
    for (std::size_t i = 0; i < count; ++i) {
      // On a grid, more than three circles touch one disc.
      const auto coordinate = [&] {
        return trial % 3 == 0 ? static_cast<double>(random.below(40)) : 40 * random.unit();
      };
      circles.push_back({coordinate(), coordinate(),
                         trial % 3 == 0 ? 0.125 * static_cast<double>(random.below(3)) : 0.3 * random.unit()});
    }
    const Diagram before = compute(circles).value();
    if (!before.hidden.empty()) continue;
    for (Circle& c : circles) {
      c.r += trial % 3 == 0 ? 0.25 : 0.2 * random.unit();
      if (trial % 4 == 0) c.x += 0.05 * random.unit();
    }
    const Diagram after = compute(circles).value();
    const auto again = recompute(before, circles);
    if (!after.hidden.empty()) {
      EXPECT_FALSE(again);
      continue;
    }
    if (!again) continue;
    ++flipped;
    EXPECT_EQ(test::differenceToTheBit(*again, after), "");
    EXPECT_TRUE(again->certificate.certified());
    EXPECT_TRUE(certify(*again).value().certified());
    EXPECT_EQ(again->stats.counts.circles, static_cast<std::int64_t>(count));
  }
  EXPECT_GT(flipped, 30);
}

TEST(Recompute, GivesNothingWhereCirclesAreHiddenOrInvalid) {
  const std::vector<Circle> circles = {{0, 0, 1}, {5, 0, 1}, {0, 5, 1}, {5, 5, 1}};
  const Diagram before = compute(circles).value();
  EXPECT_TRUE(recompute(before, circles));
  EXPECT_FALSE(recompute(before, std::vector<Circle>{{0, 0, 9}, {5, 0, 1}, {0, 5, 1}, {5, 5, 1}}));
  EXPECT_FALSE(recompute(before, std::vector<Circle>{{0, 0, -1}, {5, 0, 1}, {0, 5, 1}, {5, 5, 1}}));
}

}  // namespace
}  // namespace circle_voronoi
