// SPDX-License-Identifier: GPL-3.0-or-later
#include "step.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "build_state.h"
#include "circle_voronoi_families/families.h"
#include "trace_replay.h"

namespace circle_voronoi {
namespace {

struct Steps {
  explicit Steps(const std::vector<Circle>& circles) : state(stateOf(circles)), stepper(*state, locator) {}

  static std::unique_ptr<EditState> stateOf(const std::vector<Circle>& circles) {
    return buildState(circles, test::firstIds(circles.size()), kNone, {}).value();
  }

  std::unique_ptr<EditState> state;
  Locator locator;
  Stepper stepper;
};

/// Uniform circles and the last, in their middle, whose radius is a part of their box.
std::vector<Circle> withHider(std::size_t count, double part) {
  std::vector<Circle> circles = generate(Family::uniform, count, 1);
  Point high = {circles[0].x, circles[0].y};
  Point low = high;
  for (const Circle& c : circles) {
    low = {std::min(low.x, c.x), std::min(low.y, c.y)};
    high = {std::max(high.x, c.x), std::max(high.y, c.y)};
  }
  circles.push_back({(low.x + high.x) / 2, (low.y + high.y) / 2, part * (high.x - low.x)});
  return circles;
}

TEST(Step, ANudgeLeavesThoseAloneThatStayHidden) {
  const std::vector<Circle> circles = withHider(3000, 0.3);
  Steps steps(circles);
  const auto hidden = static_cast<std::size_t>(steps.state->circleCount - steps.state->visibleCount);
  EXPECT_GT(hidden, 700U);
  Circle nudged = circles.back();
  nudged.x += nudged.r / 50;
  EXPECT_EQ(steps.stepper.replace(steps.state->ids.slotOf(3000), nudged), EditWay::local);
  // Only circles that are inserted, removed, or next to these in the list are logged.
  EXPECT_LT(steps.state->slotLog.size(), hidden / 4);
}

TEST(Step, ThatHidesOrShowsMostIsLeftToTheWhole) {
  const std::vector<Circle> circles = withHider(3000, 0.48);
  const std::vector<Circle> without(circles.begin(), circles.end() - 1);
  Steps hiding(without);
  EXPECT_EQ(hiding.stepper.insert(circles.back(), kNone, kNone), std::nullopt);
  // Before anything has changed.
  EXPECT_TRUE(hiding.state->faceLog.empty());
  Steps growing(without);
  EXPECT_EQ(growing.stepper.replace(0, circles.back()), std::nullopt);
  EXPECT_TRUE(growing.state->faceLog.empty());
  Steps removing(circles);
  EXPECT_EQ(removing.stepper.remove(removing.state->ids.slotOf(3000)), std::nullopt);
  Steps shrinking(circles);
  Circle small = circles.back();
  small.r /= 100;
  EXPECT_EQ(shrinking.stepper.replace(shrinking.state->ids.slotOf(3000), small), std::nullopt);
}

}  // namespace
}  // namespace circle_voronoi
