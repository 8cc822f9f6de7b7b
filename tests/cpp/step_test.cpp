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
    return buildState(circles, test::firstIds(circles.size()), false).value();
  }

  Circle scaled(const Circle& circle) const { return *scaledExactly(circle, state->unit); }

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
  EXPECT_EQ(steps.stepper.replace(steps.state->ids.slotOf(3000), steps.scaled(nudged)), EditWay::local);
  // Only circles that are inserted, removed, or next to these in the list are logged.
  EXPECT_LT(steps.state->siteLog.size(), hidden / 4);
}

TEST(Step, ThatHidesOrShowsMostIsLeftToTheWhole) {
  const std::vector<Circle> circles = withHider(3000, 0.48);
  const std::vector<Circle> without(circles.begin(), circles.end() - 1);
  Steps hiding(without);
  EXPECT_EQ(hiding.stepper.insert(hiding.scaled(circles.back()), kNone), std::nullopt);
  // Before anything has changed.
  EXPECT_TRUE(hiding.state->faceLog.empty());
  Steps growing(without);
  EXPECT_EQ(growing.stepper.replace(0, growing.scaled(circles.back())), std::nullopt);
  EXPECT_TRUE(growing.state->faceLog.empty());
  Steps removing(circles);
  EXPECT_EQ(removing.stepper.remove(removing.state->ids.slotOf(3000)), std::nullopt);
  Steps shrinking(circles);
  Circle small = circles.back();
  small.r /= 100;
  EXPECT_EQ(shrinking.stepper.replace(shrinking.state->ids.slotOf(3000), shrinking.scaled(small)), std::nullopt);
}

TEST(Step, ALargerUnitKeepsTheBitsOfDirections) {
  Steps steps(generate(Family::logUniform, 200, 1));
  EditState& state = *steps.state;
  const auto directions = [&] {
    std::vector<Vector> all;
    for (int h = 0; h < state.dual.halfEdgeCount(); ++h) {
      if (state.dual.origin[h] != kPointAtInfinity) all.push_back(state.discs.direction(h));
    }
    return all;
  };
  const std::vector<Vector> before = directions();
  const Circle first = state.inputOf(0);
  EXPECT_TRUE(rescale(state, state.unit * 0x1p500));
  EXPECT_EQ(state.inputOf(0), first);
  const std::vector<Vector> after = directions();
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(after[i].x, before[i].x);
    EXPECT_EQ(after[i].y, before[i].y);
  }
  // The smallest double would round them.
  const double unit = state.unit;
  EXPECT_FALSE(rescale(state, unit * 0x1p600));
  EXPECT_EQ(state.unit, unit);
  EXPECT_EQ(state.inputOf(0), first);
}

}  // namespace
}  // namespace circle_voronoi
