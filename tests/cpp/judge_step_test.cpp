// SPDX-License-Identifier: GPL-3.0-or-later
#include "judge_step.h"

#include <gtest/gtest.h>

#include <optional>
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
  return buildState(circles, test::firstIds(circles.size()), kNone, {}).value();
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

struct Verdicts {
  int right = 0;
  int wrong = 0;
};

/// Changes diagrams of all families at random, and expects the judge of a step to agree with the judge of the whole.
/// `change` returns the slot of the circle that has moved (kNone if none has), or nothing if it gave up.
template <class Change>
Verdicts compareJudges(int trials, Change change) {
  const std::uint64_t seed = test::seedOr(1);
  Verdicts verdicts;
  for (const FamilyInfo& family : families()) {
    const auto state = stateOf(generate(family.family, 30, seed));
    if (state->visibleCount < 3) continue;
    StepJudge judge;
    Random random(seed);
    for (int trial = 0; trial < trials; ++trial) {
      const EditState::Mark mark = state->beginStep();
      if (const std::optional<int> moved = change(*state, random)) {
        const bool isRight = isWholeRight(*state);
        EXPECT_EQ(judge.judge(*state, *moved) == StepVerdict::right, isRight) << family.name << ", trial " << trial;
        (isRight ? verdicts.right : verdicts.wrong) += 1;
      }
      state->rollBack(mark);
      EXPECT_TRUE(isWholeRight(*state)) << family.name;
    }
  }
  return verdicts;
}

TEST(JudgeStep, AgreesWithTheJudgeOfTheWhole) {
  const Verdicts verdicts = compareJudges(200, [](EditState& state, Random& random) -> std::optional<int> {
    for (std::size_t flips = 1 + random.below(3); flips > 0; --flips) {
      const auto halfEdges = static_cast<std::size_t>(state.dual.halfEdgeCount());
      if (!flipEdge(state, static_cast<int>(random.below(halfEdges)))) return std::nullopt;
    }
    return kNone;
  });
  // Flips of ties, and edges flipped back.
  EXPECT_GT(verdicts.right, 30);
  EXPECT_GT(verdicts.wrong, 1000);
}

TEST(JudgeStep, SeesThatACircleHasMovedTooFar) {
  const Verdicts verdicts = compareJudges(100, [](EditState& state, Random& random) -> std::optional<int> {
    const auto anyVisible = [&] { return random.below(static_cast<std::size_t>(state.visibleCount)); };
    const int slot = static_cast<int>(anyVisible());
    state.willChangeSlot(slot);
    for (int h = 0; h < state.dual.halfEdgeCount(); ++h) {
      if (state.dual.origin[h] == slot) state.willChange(h / 3);
    }
    const Circle& other = state.circles[anyVisible()];
    Circle& circle = state.circles[slot];
    const double step = random.logUniform(-8, 0);
    circle.x += step * (other.x - circle.x);
    circle.y += step * (other.y - circle.y);
    // Other tests look for circles that it no longer hides.
    while (state.slots[slot].firstHidden != kNone) {
      const int inner = state.slots[slot].firstHidden;
      state.detach(inner);
      state.removeSlot(inner);
    }
    return slot;
  });
  EXPECT_GT(verdicts.right, 300);
  EXPECT_GT(verdicts.wrong, 300);
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
  state->rollBack(mark);

  // A circle taken away though it hides others.
  mark = state->beginStep();
  CellShrinker shrinker;
  ASSERT_TRUE(shrinker.takeOut(*state, first));
  --state->visibleCount;
  state->removeSlot(first);
  EXPECT_EQ(judge.judge(*state, kNone), StepVerdict::wrong);
  state->rollBack(mark);

  // A visible circle that is not in the dual.
  mark = state->beginStep();
  state->detach(inner);
  state->hasNoCell[inner] = 0;
  EXPECT_EQ(judge.judge(*state, kNone), StepVerdict::wrong);
  ++state->visibleCount;
  EXPECT_EQ(judge.judge(*state, kNone), StepVerdict::broken);
  state->rollBack(mark);
  EXPECT_TRUE(isWholeRight(*state));
}

}  // namespace
}  // namespace circle_voronoi
