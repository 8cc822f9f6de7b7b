// SPDX-License-Identifier: GPL-3.0-or-later
// Events replayed one by one give the diagram: of every family, by every method, and through edits.
#include "trace_replay.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "circle_voronoi/compute.h"
#include "circle_voronoi/editor.h"
#include "circle_voronoi/trace.h"
#include "circle_voronoi_families/families.h"
#include "random.h"
#include "report.h"

namespace circle_voronoi {
namespace {

/// More than a thousand of all families together.
constexpr int kInputs = 24;

TEST(TraceReplay, GivesTheDiagramOfEveryFamilyByEveryMethod) {
  const std::uint64_t seed = test::seedOr(1);
  int inputs = 0;
  int reasons = 0;
  for (const FamilyInfo& family : families()) {
    for (int k = 0; k < kInputs; ++k, ++inputs) {
      Random random(seed + static_cast<std::uint64_t>(k));
      const std::vector<Circle> circles =
          generate(family.family, random.below(k % 8 == 0 ? 60 : 14), seed + static_cast<std::uint64_t>(k));
      for (const Method method : {Method::automatic, Method::flip, Method::touchingDisc}) {
        SCOPED_TRACE(std::string(family.name) + ", seed " + std::to_string(seed) + ", input " + std::to_string(k) +
                     ", method " + std::to_string(static_cast<int>(method)));
        test::Replay replay;
        replay.know(circles);
        Options options;
        options.method = method;
        options.observer = [&](const TraceEvent& event) { replay.see(event); };
        const auto diagram = compute(circles, options);
        ASSERT_TRUE(diagram.ok());
        reasons += replay.reasons;
        replay.expectDiagram(diagram.value(), test::firstIds(circles.size()));
        if (testing::Test::HasFailure()) FAIL() << test::describe(circles);

        options.observer = {};
        const auto untold = compute(circles, options);
        EXPECT_EQ(untold.value().vertices, diagram.value().vertices);
        EXPECT_EQ(untold.value().stats.counts.filtered, diagram.value().stats.counts.filtered) << "told costs signs";
      }
    }
  }
  EXPECT_GE(inputs, 1000);
  EXPECT_GT(reasons, inputs);
}

TEST(TraceReplay, GivesTheDiagramAfterEachEdit) {
  const std::uint64_t seed = test::seedOr(1);
  std::map<TraceKind, int> seen;
  for (const FamilyInfo& family : families()) {
    SCOPED_TRACE(std::string(family.name) + ", seed " + std::to_string(seed));
    Random random(seed);
    const std::vector<Circle> circles = generate(family.family, 4 + random.below(30), seed);
    auto made = DiagramEditor::from(circles);
    ASSERT_TRUE(made.ok());
    DiagramEditor editor = std::move(made).value();
    test::Replay replay;
    replay.know(circles);
    ASSERT_TRUE(editor.observe([&](const TraceEvent& event) {
      ++seen[event.kind];
      replay.see(event);
    }));
    for (int k = 0; k < 30; ++k) {
      const std::vector<CircleId> ids = editor.ids();
      const CircleId id = ids[random.below(ids.size())];
      const Circle other = *editor.circle(ids[random.below(ids.size())]);
      const Circle circle = *editor.circle(id);
      const Circle between = {(circle.x + other.x) / 2, (circle.y + other.y) / 2, k % 5 == 0 ? other.r * 2 : circle.r};
      const auto change = k % 3 == 0   ? editor.insert(between)
                          : k % 3 == 1 ? editor.replace(id, between)
                                       : editor.remove(id);
      ASSERT_TRUE(change.ok());
      replay.expectDiagram(editor.snapshot().value(), editor.ids());
      if (testing::Test::HasFailure()) FAIL() << "edit " << k << " of " << test::describe(circles);
    }
    // Refused edits cause no events.
    const std::vector<Edit> refused = {{Edit::Kind::insert, kNone, circles[0]}, {Edit::Kind::remove, 1000000, {}}};
    const int told = seen[TraceKind::circleInserted];
    EXPECT_FALSE(editor.apply(refused).ok());
    EXPECT_EQ(seen[TraceKind::circleInserted], told);
    ASSERT_TRUE(editor.insert(circles[0]).ok());
    EXPECT_EQ(seen[TraceKind::circleInserted], told + 1);
    replay.expectDiagram(editor.snapshot().value(), editor.ids());
  }
  for (const TraceKind kind : {TraceKind::circleShrunk, TraceKind::circleReplaced, TraceKind::circleRemoved,
                               TraceKind::discNotEmpty, TraceKind::hullNotConvex}) {
    EXPECT_GT(seen[kind], 0) << traceKindName(kind);
  }
}

TEST(TraceReplay, CountsTheRoundsThatEditsBegin) {
  auto made = DiagramEditor::from(generate(Family::uniform, 200, 1));
  DiagramEditor editor = std::move(made).value();
  std::vector<int> rounds;
  EXPECT_TRUE(editor.observe([&](const TraceEvent& event) {
    if (event.kind == TraceKind::roundBegun) rounds.push_back(event.numbers[0]);
  }));
  ASSERT_EQ(editor.insert({0, 0, 1}).value().way, EditWay::local);
  EXPECT_EQ(rounds, std::vector<int>{0}) << "what is edited in its place begins none";
  const std::vector<Edit> many(60, {Edit::Kind::replace, 7, {1, 2, 3}});
  for (int k = 0; k < 2; ++k) ASSERT_EQ(editor.apply(many).value().way, EditWay::whole);
  EXPECT_EQ(rounds, (std::vector<int>{0, 1, 2}));
}

}  // namespace
}  // namespace circle_voronoi
