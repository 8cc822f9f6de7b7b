// SPDX-License-Identifier: GPL-3.0-or-later
#include "judge_step.h"

#include <gtest/gtest.h>

#include <vector>

#include "build_state.h"
#include "circle_voronoi_families/families.h"
#include "judge.h"
#include "random.h"
#include "report.h"
#include "shrink_cell.h"
#include "trace_replay.h"

namespace circle_voronoi {
namespace {

std::unique_ptr<EditState> stateOf(const std::vector<Circle>& circles) {
  return buildState(circles, test::firstIds(circles.size()), false).value();
}

/// Flips an edge, right or wrong; whether that left no loop.
bool flipEdge(EditState& state, int h) {
  Dual& dual = state.dual;
  const int t = dual.twin[h];
  if (dual.origin[Dual::previous(h)] == dual.origin[Dual::previous(t)]) return false;
  for (const int changed : {h, t, dual.twin[Dual::next(t)], dual.twin[Dual::next(h)]}) state.willChange(changed / 3);
  dual.flip(h);
  return true;
}

/// The verdict of the judge of the whole dual.
bool isWholeRight(EditState& state) {
  return judge(std::span(state.circles).first(static_cast<std::size_t>(state.visibleCount)), state.dual,
               state.predicates)
      .isRight();
}

TEST(JudgeStep, AgreesWithTheJudgeOfTheWhole) {
  const std::uint64_t seed = test::seedOr(1);
  int right = 0;
  int wrong = 0;
  for (const FamilyInfo& family : families()) {
    const auto state = stateOf(generate(family.family, 30, seed));
    if (state->visibleCount < 3) continue;
    StepJudge judge;
    Random random(seed);
    for (int trial = 0; trial < 200; ++trial) {
      const EditState::Mark mark = state->beginStep();
      bool isFlipped = true;
      for (std::size_t flips = 1 + random.below(3); flips > 0 && isFlipped; --flips) {
        isFlipped =
            flipEdge(*state, static_cast<int>(random.below(static_cast<std::size_t>(state->dual.halfEdgeCount()))));
      }
      const bool isRight = isWholeRight(*state);
      if (isFlipped) {
        EXPECT_EQ(judge.judge(*state, kNone) == StepVerdict::right, isRight) << family.name << ", trial " << trial;
        (isRight ? right : wrong) += 1;
      }
      state->takeBack(mark);
      ASSERT_TRUE(isWholeRight(*state)) << family.name;
    }
  }
  // Flips of ties, and edges flipped back.
  EXPECT_GT(right, 30);
  EXPECT_GT(wrong, 1000);
}

TEST(JudgeStep, SeesThatACircleHasMovedTooFar) {
  const std::uint64_t seed = test::seedOr(1);
  int right = 0;
  int wrong = 0;
  for (const FamilyInfo& family : families()) {
    const auto state = stateOf(generate(family.family, 30, seed));
    if (state->visibleCount < 3) continue;
    StepJudge judge;
    Random random(seed);
    for (int trial = 0; trial < 100; ++trial) {
      const EditState::Mark mark = state->beginStep();
      const int slot = static_cast<int>(random.below(static_cast<std::size_t>(state->visibleCount)));
      state->willChangeSite(slot);
      for (int h = 0; h < state->dual.halfEdgeCount(); ++h) {
        if (state->dual.origin[h] == slot) state->willChange(h / 3);
      }
      const Circle& other = state->circles[random.below(static_cast<std::size_t>(state->visibleCount))];
      Circle& circle = state->circles[slot];
      const double step = random.logUniform(-8, 0);
      circle.x += step * (other.x - circle.x);
      circle.y += step * (other.y - circle.y);
      // Circles that it no longer hides are another matter.
      while (state->sites[slot].firstHidden != kNone)
        state->removeSite([&] {
          const int inner = state->sites[slot].firstHidden;
          state->detach(inner);
          return inner;
        }());
      const bool isRight = isWholeRight(*state);
      EXPECT_EQ(judge.judge(*state, slot) == StepVerdict::right, isRight) << family.name << ", trial " << trial;
      (isRight ? right : wrong) += 1;
      state->takeBack(mark);
    }
  }
  EXPECT_GT(right, 300);
  EXPECT_GT(wrong, 300);
}

TEST(JudgeStep, WantsHiddenCirclesInTheListOfAVisibleOneThatContainsThem) {
  const auto state = stateOf({{0, 0, 4}, {10, 0, 2}, {0, 12, 3}, {1, 1, 1}, {-1, 0, 1}});
  ASSERT_EQ(state->visibleCount, 3);
  const int first = state->ids.slotOf(0);
  const int second = state->ids.slotOf(1);
  const int inner = state->ids.slotOf(3);
  StepJudge judge;
  EditState::Mark mark = state->beginStep();
  state->detach(inner);
  EXPECT_EQ(judge.judge(*state, kNone), StepVerdict::wrong);
  state->attach(inner, first);
  EXPECT_EQ(judge.judge(*state, kNone), StepVerdict::right);
  state->detach(inner);
  state->attach(inner, second);
  EXPECT_EQ(judge.judge(*state, kNone), StepVerdict::wrong);
  state->takeBack(mark);

  // A circle taken away though it hides others.
  mark = state->beginStep();
  CellShrinker shrinker;
  ASSERT_TRUE(shrinker.takeOut(*state, first));
  --state->visibleCount;
  state->removeSite(first);
  EXPECT_EQ(judge.judge(*state, kNone), StepVerdict::wrong);
  state->takeBack(mark);

  // A visible circle that is not in the dual.
  mark = state->beginStep();
  state->detach(inner);
  state->isHidden[inner] = 0;
  EXPECT_EQ(judge.judge(*state, kNone), StepVerdict::wrong);
  ++state->visibleCount;
  EXPECT_EQ(judge.judge(*state, kNone), StepVerdict::broken);
  state->takeBack(mark);
  EXPECT_TRUE(isWholeRight(*state));
}

}  // namespace
}  // namespace circle_voronoi
