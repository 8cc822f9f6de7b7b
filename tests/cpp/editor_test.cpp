// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/editor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "circle_voronoi/compute.h"
#include "circle_voronoi_families/families.h"
#include "edit_script.h"
#include "random.h"
#include "report.h"

namespace circle_voronoi {
namespace {

DiagramEditor editorOf(const std::vector<Circle>& circles) {
  auto editor = DiagramEditor::from(circles);
  EXPECT_TRUE(editor.ok()) << (editor.ok() ? "" : editor.error().message);
  return std::move(editor).value();
}

/// Expects the diagram of `compute`, to the bit, and that `certify` accepts it.
void expectRight(const DiagramEditor& editor) {
  const auto snapshot = editor.snapshot();
  ASSERT_TRUE(snapshot.ok()) << snapshot.error().message;
  EXPECT_EQ(test::differenceToTheBit(snapshot.value(), compute(editor.circles()).value()), "");
  EXPECT_TRUE(editor.certificate().value().certified());
}

Change changeOf(Result<Change> change) {
  EXPECT_TRUE(change.ok()) << (change.ok() ? "" : change.error().message);
  return change.ok() ? std::move(change).value() : Change{};
}

/// An editor and a mirror of its changes. After each change the mirror, the snapshot and a computed diagram are the
/// same.
class Watched {
 public:
  explicit Watched(DiagramEditor editor) : editor_(std::move(editor)) { mirror_.apply(editor_.all().value()); }
  explicit Watched(const std::vector<Circle>& circles) : Watched(editorOf(circles)) {}

  DiagramEditor* operator->() { return &editor_; }

  std::vector<CircleId> hidden() const {
    std::vector<CircleId> hidden;
    for (const CircleId id : editor_.ids()) {
      if (editor_.isHidden(id)) hidden.push_back(id);
    }
    return hidden;
  }

  Change apply(const std::vector<Edit>& edits) { return changed(editor_.apply(edits)); }
  Change insert(const Circle& circle) { return changed(editor_.insert(circle)); }
  Change remove(CircleId id) { return changed(editor_.remove(id)); }
  Change replace(CircleId id, const Circle& circle) { return changed(editor_.replace(id, circle)); }

 private:
  Change changed(Result<Change> result) {
    Change change = changeOf(std::move(result));
    EXPECT_EQ(mirror_.apply(change), "");
    EXPECT_EQ(mirror_.difference(editor_.snapshot().value(), editor_.ids()), "");
    expectRight(editor_);
    return change;
  }

  DiagramEditor editor_;
  test::Mirror mirror_;
};

TEST(Editor, IsRightThroughRandomScriptsInEveryFamily) {
  const std::uint64_t seed = test::seedOr(1);
  std::cout << "seed " << seed << '\n';
  int ways[3] = {};
  for (const FamilyInfo& family : families()) {
    for (std::uint64_t i = 0; i < 6; ++i) {
      const std::size_t count = i % 2 == 0 ? 30 : 4;
      const test::ScriptResult result = test::runScript(family, count, 100, seed + i);
      EXPECT_EQ(result.problem, "") << family.name << ", " << count << " circles, seed " << seed + i;
      if (count < 10) continue;
      for (int way = 0; way < 3; ++way) ways[way] += result.ways[way];
    }
  }
  std::cout << ways[0] << " local, " << ways[1] << " patch, " << ways[2] << " whole\n";
  // Each way is taken, and the first by far the most.
  EXPECT_GT(ways[1], 0);
  EXPECT_GT(ways[2], 0);
  EXPECT_LT(20 * (ways[1] + ways[2]), ways[0]);
}

TEST(Editor, MakesADiagramOfNothingAndNothingOfADiagram) {
  for (const Family family : {Family::uniform, Family::hidden, Family::grid, Family::collinear, Family::duplicates}) {
    const std::vector<Circle> circles = generate(family, 60, 3);
    Watched editor(std::vector<Circle>{});
    for (const Circle& circle : circles) editor.insert(circle);
    EXPECT_EQ(editor->circles(), circles);
    for (CircleId id = 0; id < 60; ++id) editor.remove(id);
    EXPECT_EQ(editor->size(), 0U);
  }
}

TEST(Editor, NeverGivesAnIdAgain) {
  DiagramEditor editor = editorOf(generate(Family::uniform, 20, 1));
  CircleId last = 19;
  for (int i = 0; i < 3000; ++i) {
    const Change change = changeOf(editor.insert({i * 0.001, 0.5, 0.0001}));
    const CircleId id = change.inserted.at(0);
    EXPECT_GT(id, last);
    last = id;
    // Numbers are given again: there are never more than 21 circles.
    for (const auto vertex : change.addedVertices) EXPECT_LT(vertex, 60);
    for (const auto edge : change.addedEdges) EXPECT_LT(edge, 90);
    changeOf(editor.remove(id));
    EXPECT_FALSE(editor.circle(id));
  }
  expectRight(editor);
}

TEST(Editor, InsertsARemovedCircleUnderItsId) {
  const std::vector<Circle> circles = generate(Family::uniform, 300, 1);
  Watched editor(circles);
  editor.apply({{Edit::Kind::remove, 7, {}}, {Edit::Kind::remove, 3, {}}});
  const Change local = editor.apply({{Edit::Kind::insert, 7, circles[7]},
                                     {Edit::Kind::insert, kNone, {0.5, 0.25, 0}},
                                     {Edit::Kind::insert, 3, circles[3]},
                                     {Edit::Kind::replace, 3, circles[7]}});
  EXPECT_EQ(local.way, EditWay::local);
  EXPECT_EQ(local.inserted, (std::vector<CircleId>{7, 300, 3}));
  // Identical circles: the lower id is visible.
  EXPECT_TRUE(editor->isHidden(7));
  EXPECT_FALSE(editor->isHidden(3));
  // A circle that comes and goes in a batch may come again later.
  editor.apply({{Edit::Kind::remove, 300, {}}});
  EXPECT_TRUE(editor.apply({{Edit::Kind::insert, 300, {1, 1, 0}}, {Edit::Kind::remove, 300, {}}}).inserted.empty());
  editor.apply({{Edit::Kind::insert, 300, {1, 1, 0}}});
  std::vector<Edit> removals;
  std::vector<Edit> insertions;
  for (CircleId id = 0; id < 300; ++id) {
    if (id % 3 == 0) continue;
    removals.push_back({Edit::Kind::remove, id, {}});
    insertions.push_back({Edit::Kind::insert, id, circles[static_cast<std::size_t>(id)]});
  }
  std::ranges::reverse(insertions);
  EXPECT_EQ(editor.apply(removals).way, EditWay::whole);
  insertions.push_back({Edit::Kind::insert, kNone, {0.5, 0.25, 0}});
  const Change whole = editor.apply(insertions);
  EXPECT_EQ(whole.way, EditWay::whole);
  EXPECT_EQ(whole.inserted.size(), insertions.size());
  EXPECT_EQ(editor->ids().back(), 301);
  EXPECT_EQ(*editor->circle(100), circles[100]);
}

TEST(Editor, RefusesAnIdThatIsNotOfARemovedCircle) {
  const auto insertion = [](CircleId id) { return Edit{Edit::Kind::insert, id, {0.5, 0.5, 0.1}}; };
  const Edit away = {Edit::Kind::remove, 7, {}};
  Watched editor(generate(Family::uniform, 40, 1));
  editor.remove(3);
  const auto expectRefusal = [&](std::vector<Edit> edits, CircleId id) {
    // Large batches compute the whole diagram.
    for (const std::size_t others : {0U, 100U}) {
      edits.insert(edits.begin(), others, insertion(kNone));
      const auto change = editor->apply(edits);
      ASSERT_FALSE(change.ok());
      EXPECT_EQ(change.error().code, ErrorCode::unknownCircle);
      EXPECT_EQ(change.error().circle, id);
      EXPECT_EQ(change.error().edit, static_cast<std::int64_t>(edits.size()) - 1);
      EXPECT_EQ(editor->size(), 39U);
      EXPECT_FALSE(editor->circle(3));
    }
  };
  expectRefusal({insertion(5)}, 5);
  expectRefusal({insertion(-2)}, -2);
  expectRefusal({insertion(1000)}, 1000);
  expectRefusal({insertion(3), insertion(3)}, 3);
  expectRefusal({away, insertion(7)}, 7);
  expectRefusal({insertion(3), {Edit::Kind::remove, 3, {}}, insertion(3)}, 3);
  EXPECT_EQ(editor->apply({{{Edit::Kind::insert, 3, {0, 0, -1}}}}).error().circle, 3);
  EXPECT_EQ(editor.apply({insertion(3), insertion(kNone)}).inserted, (std::vector<CircleId>{3, 40}));
}

TEST(Editor, StartsWithGivenIds) {
  const std::vector<Circle> circles = generate(Family::hidden, 60, 1);
  std::vector<CircleId> ids;
  for (std::int32_t i = 0; i < 60; ++i) ids.push_back(1000 * i + 5);
  Watched editor(DiagramEditor::from(circles, {.ids = ids, .nextId = 70'000}).value());
  EXPECT_EQ(editor->ids(), ids);
  EXPECT_EQ(editor->circles(), circles);
  // Another editor may have removed circles with the ids between.
  const Change change = editor.apply({{Edit::Kind::insert, 69'999, circles[0]},
                                      {Edit::Kind::insert, 0, circles[0]},
                                      {Edit::Kind::remove, 5, {}},
                                      {Edit::Kind::insert, kNone, circles[1]}});
  EXPECT_EQ(change.inserted, (std::vector<CircleId>{69'999, 0, 70'000}));
  EXPECT_FALSE(editor->apply({{{Edit::Kind::insert, 70'001, circles[0]}}}).ok());
  DiagramEditor other = DiagramEditor::from(circles, {.ids = ids}).value();
  EXPECT_FALSE(other.remove(99).ok());
  EXPECT_EQ(changeOf(other.insert(circles[0])).inserted.at(0), ids.back() + 1);
}

TEST(Editor, RefusesNewCirclesOnceAllIdsAreGivenOut) {
  const std::vector<Circle> circles = {{0, 0, 1}, {6, 0, 1}};
  const std::vector<CircleId> ids = {3, 2147483645};
  DiagramEditor editor = DiagramEditor::from(circles, {.ids = ids}).value();
  const Edit insertion = {Edit::Kind::insert, kNone, {3, 5, 1}};
  for (const std::size_t count : {2U, 100U}) {
    const auto change = editor.apply(std::vector<Edit>(count, insertion));
    ASSERT_FALSE(change.ok());
    EXPECT_EQ(change.error().code, ErrorCode::tooManyCircles);
    EXPECT_EQ(change.error().edit, 1);
    EXPECT_EQ(editor.ids(), ids);
  }
  EXPECT_EQ(changeOf(editor.insert(insertion.circle)).inserted, (std::vector<CircleId>{2147483646}));
  EXPECT_EQ(editor.insert({9, 9, 1}).error().code, ErrorCode::tooManyCircles);
  EXPECT_EQ(changeOf(editor.apply(std::vector<Edit>{{Edit::Kind::insert, 5, {9, 9, 1}}})).inserted,
            (std::vector<CircleId>{5}));
  expectRight(editor);
}

TEST(Editor, RefusesIdsThatDoNotFit) {
  const std::vector<Circle> circles = {{0, 0, 1}, {6, 0, 1}};
  const std::vector<std::pair<std::vector<CircleId>, CircleId>> cases = {
      {{4}, kNone}, {{4, 4}, kNone}, {{-1, 4}, kNone}, {{4, 2147483647}, kNone}, {{4, 7}, 7}, {{}, 1}};
  for (const auto& [ids, nextId] : cases) {
    const auto editor = DiagramEditor::from(circles, {.ids = ids, .nextId = nextId});
    ASSERT_FALSE(editor.ok()) << testing::PrintToString(ids.size());
    EXPECT_EQ(editor.error().code, ErrorCode::badOption);
  }
}

double reachOf(const std::vector<Circle>& circles) {
  double reach = 0;
  for (const Circle& c : circles) reach = std::max({reach, std::abs(c.x), std::abs(c.y)});
  return reach;
}

TEST(Editor, RestoresTheCirclesThatAHugeCircleHid) {
  const std::vector<Circle> circles = generate(Family::uniform, 12'000, 1);
  Watched editor(circles);
  const double reach = reachOf(circles);
  const Change hiding = editor.insert({0.4 * reach, 0.5 * reach, 0.26 * reach});
  EXPECT_EQ(hiding.way, EditWay::local);
  EXPECT_GT(hiding.hidden.size(), 2'000U);
  // It moves, and hides others.
  const Change moving = editor.replace(12'000, {0.6 * reach, 0.5 * reach, 0.25 * reach});
  EXPECT_FALSE(moving.hidden.empty());
  EXPECT_FALSE(moving.shown.empty());
  EXPECT_EQ(moving.way, EditWay::local);
  EXPECT_EQ(editor.remove(12'000).way, EditWay::local);
  EXPECT_TRUE(editor.hidden().empty());
  EXPECT_EQ(editor->circles(), circles);
}

TEST(Editor, ComputesTheWholeDiagramIfMostCirclesAreHiddenOrShown) {
  const std::vector<Circle> circles = generate(Family::uniform, 2'000, 1);
  Watched editor(circles);
  const auto expectWhole = [](const Change& change) {
    EXPECT_EQ(change.way, EditWay::whole);
    EXPECT_GT(change.hidden.size() + change.shown.size(), 1'000U);
  };
  const double reach = reachOf(circles);
  const Circle hider = {0.5 * reach, 0.5 * reach, 0.5 * reach};
  expectWhole(editor.insert(hider));
  expectWhole(editor.remove(2'000));
  expectWhole(editor.replace(7, hider));
  expectWhole(editor.replace(7, circles[7]));
}

TEST(Editor, PassesHiddenCirclesToAnotherHider) {
  // 0 hides 3 and 4, and then comes to lie in 1, with 3.
  Watched editor({{-2, 0, 4}, {11, 0, 10}, {0, 40, 1}, {1.5, 0, 0.3}, {-3, 0, 1}, {0, -40, 1}, {-40, 0, 1}});
  EXPECT_EQ(editor.hidden(), (std::vector<CircleId>{3, 4}));
  const Change change = editor.replace(0, {5, 0, 3.9});
  EXPECT_EQ(change.hidden, std::vector<CircleId>{0});
  EXPECT_EQ(change.shown, std::vector<CircleId>{4});
  EXPECT_EQ(editor.hidden(), (std::vector<CircleId>{0, 3}));
  // The circles that it handed over are not in its list any more when it comes back.
  EXPECT_EQ(editor.replace(0, {-2, 0, 4}).way, EditWay::local);
  EXPECT_EQ(editor.hidden(), (std::vector<CircleId>{3, 4}));
  EXPECT_EQ(editor.replace(0, {5, 0, 3.9}).way, EditWay::local);
  EXPECT_EQ(editor.remove(0).way, EditWay::local);
  editor.insert({5, 0, 3.9});
  EXPECT_EQ(editor.remove(3).way, EditWay::local);
  // It comes to be identical with 1, and takes its place.
  Watched other({{5, 0, 3.9}, {11, 0, 10}, {0, 40, 1}, {1.5, 0, 0.3}, {-3, 0, 1}, {0, -40, 1}, {-40, 0, 1}});
  other.replace(0, {11, 0, 10});
  EXPECT_EQ(other.hidden(), (std::vector<CircleId>{1, 3}));
}

TEST(Editor, OfIdenticalCirclesShowsTheFirst) {
  const std::vector<Circle> circles = {{0, 0, 1}, {10, 0, 2}, {0, 9, 1}, {-8, -7, 1}, {5, 5, 1}};
  Watched editor(circles);
  const CircleId copy = editor.insert(circles[4]).inserted.at(0);
  EXPECT_EQ(editor.hidden(), std::vector<CircleId>{copy});
  // Circle 2 comes to be identical with both, and has the lowest id.
  EXPECT_EQ(editor.replace(2, circles[4]).hidden, std::vector<CircleId>{4});
  EXPECT_EQ(editor.hidden(), (std::vector<CircleId>{4, copy}));
  editor.remove(2);
  EXPECT_EQ(editor.hidden(), std::vector<CircleId>{copy});
  // A circle that shrinks onto one of lower id that it hid.
  editor.insert({5, 5, 2});
  EXPECT_EQ(editor.hidden(), (std::vector<CircleId>{4, copy}));
  editor.replace(6, {5, 5, 1});
  EXPECT_EQ(editor.hidden(), (std::vector<CircleId>{copy, 6}));
}

TEST(Editor, ShowsHiddenCirclesThatNoOtherCircleHides) {
  Watched editor({{0, 0, 9}, {40, 0, 1}, {0, 40, 1}, {1, 0, 1}, {1, 0, 3}, {1, 0, 2}, {-4, 0, 1}});
  EXPECT_EQ(editor.remove(0).way, EditWay::local);
  EXPECT_EQ(editor.hidden(), (std::vector<CircleId>{3, 5}));
}

TEST(Editor, RefusesWithoutATrace) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  DiagramEditor editor = editorOf(generate(Family::hidden, 40, 1));
  const auto before = editor.snapshot().value();
  const Change allBefore = editor.all().value();
  const auto expectRefusal = [&](const std::vector<Edit>& edits, ErrorCode code, std::int64_t edit,
                                 CircleId circle = kNone) {
    const auto change = editor.apply(edits);
    ASSERT_FALSE(change.ok());
    EXPECT_EQ(change.error().code, code);
    EXPECT_EQ(change.error().edit, edit);
    EXPECT_EQ(change.error().circle, circle);
    EXPECT_EQ(editor.size(), 40U);
    EXPECT_EQ(test::differenceToTheBit(editor.snapshot().value(), before), "");
    const Change all = editor.all().value();
    EXPECT_EQ(all.addedVertices, allBefore.addedVertices);
    EXPECT_EQ(all.addedEdges, allBefore.addedEdges);
    EXPECT_EQ(all.edges, allBefore.edges);
  };
  const Edit good = {Edit::Kind::insert, kNone, {0.5, 0.5, 0.1}};
  const Edit away = {Edit::Kind::remove, 7, {}};
  const Edit moves = {Edit::Kind::replace, 8, {0.2, 0.3, 0.5}};
  expectRefusal({{Edit::Kind::insert, kNone, {kInfinite, 0, 0}}}, ErrorCode::nonFinite, 0);
  expectRefusal({good, away, {Edit::Kind::replace, 3, {0, 0, -1}}}, ErrorCode::negativeRadius, 2, 3);
  expectRefusal({good, {Edit::Kind::insert, kNone, {0, 1e29, 0}}}, ErrorCode::coordinateTooLarge, 1);
  expectRefusal({good, away, moves, away}, ErrorCode::unknownCircle, 3, 7);
  expectRefusal({good, {Edit::Kind::replace, 41, {}}}, ErrorCode::unknownCircle, 1, 41);
  expectRefusal({{Edit::Kind::remove, -1, {}}}, ErrorCode::unknownCircle, 0);
  // The batch is also refused if it is so large that the whole diagram would be computed.
  std::vector<Edit> many(100, good);
  many.push_back(away);
  many.push_back(away);
  expectRefusal(many, ErrorCode::unknownCircle, 101, 7);
  // And the first new circle has the first new id.
  EXPECT_EQ(changeOf(editor.insert({0.5, 0.5, 0.1})).inserted, std::vector<CircleId>{40});
}

TEST(Editor, NumbersNewEdgesWithFreeNumbersAfterARefusal) {
  Watched editor(std::vector<Circle>{});
  for (const Circle& circle : generate(Family::uniform, 30, 1)) {
    editor.insert(circle);
    EXPECT_FALSE(editor->remove(99).ok());
  }
}

// A refused batch restores the list of circles that a circle hides, whichever entry it edits: any later edit there is
// still local.
TEST(Editor, ARefusedBatchLeavesTheListsOfHiddenCirclesAlone) {
  const std::vector<Circle> circles = {{0, 0, 9}, {40, 0, 1}, {0, 40, 1},  {-40, -40, 1},
                                       {1, 0, 1}, {-3, 0, 1}, {0, 4, 0.5}, {0, -4, 0.25}};
  const Edit unknown = {Edit::Kind::remove, 99, {}};
  for (const std::int32_t refused : {4, 5, 6, 7}) {
    for (const std::int32_t next : {4, 5, 6, 7}) {
      SCOPED_TRACE(std::to_string(refused) + ", then " + std::to_string(next));
      DiagramEditor editor = editorOf(circles);
      EXPECT_FALSE(editor.apply(std::vector<Edit>{{Edit::Kind::remove, refused, {}}, unknown}).ok());
      EXPECT_FALSE(editor.apply(std::vector<Edit>{{Edit::Kind::insert, kNone, {2, 2, 0.125}}, unknown}).ok());
      EXPECT_EQ(changeOf(editor.remove(next)).way, EditWay::local);
      const Change shown = changeOf(editor.remove(0));
      EXPECT_EQ(shown.way, EditWay::local);
      EXPECT_EQ(shown.shown.size(), 3U);
      expectRight(editor);
    }
  }
}

TEST(Editor, ABatchIsOneChange) {
  const std::vector<Circle> circles = generate(Family::uniform, 300, 1);
  const std::vector<Edit> edits = {{Edit::Kind::remove, 5, {}},
                                   {Edit::Kind::insert, kNone, circles[5]},
                                   {Edit::Kind::replace, 300, {circles[6].x, circles[6].y, circles[6].r / 2}},
                                   {Edit::Kind::insert, kNone, circles[7]},
                                   {Edit::Kind::remove, 301, {}},
                                   {Edit::Kind::replace, 9, circles[9]}};
  Watched editor(circles);
  const Change change = editor.apply(edits);
  EXPECT_EQ(change.way, EditWay::local);
  EXPECT_EQ(change.inserted, std::vector<CircleId>{300});
  EXPECT_EQ(change.removed, std::vector<CircleId>{5});
  EXPECT_TRUE(change.replaced.empty());
  EXPECT_EQ(change.hidden, std::vector<CircleId>{300});
  // Enough edits that everything is recomputed.
  std::vector<Edit> many;
  for (CircleId id = 100; id < 300; ++id) many.push_back({Edit::Kind::remove, id, {}});
  for (int i = 0; i < 50; ++i) many.push_back({Edit::Kind::insert, kNone, {i * 0.01, i * 0.02, 0.001}});
  many.push_back({Edit::Kind::remove, 310, {}});
  EXPECT_EQ(editor.apply(many).way, EditWay::whole);
  EXPECT_FALSE(editor->circle(310));
  EXPECT_EQ(editor->ids().back(), 351);
}

TEST(Editor, ASnapshotCountsAllCirclesAndTheHiddenOnes) {
  DiagramEditor editor = editorOf({{0, 0, 9}, {40, 0, 1}, {0, 40, 1}, {1, 0, 1}});
  changeOf(editor.insert({2, 0, 1}));
  const Counts counts = editor.snapshot().value().stats.counts;
  EXPECT_EQ(counts.circles, 5);
  EXPECT_EQ(counts.hidden, 2);
}

TEST(Editor, MapsIndicesOfASnapshotToIds) {
  const std::vector<Circle> circles = generate(Family::hidden, 120, 2);
  DiagramEditor editor = editorOf(circles);
  for (CircleId id = 0; id < 40; ++id) {
    changeOf(editor.replace(id, circles[static_cast<std::size_t>(id) + 60]));
    changeOf(editor.remove(id + 40));
    changeOf(editor.insert(circles[static_cast<std::size_t>(id) + 20]));
  }
  const Diagram snapshot = editor.snapshot().value();
  const SnapshotNumbers numbers = editor.numbers().value();
  EXPECT_EQ(numbers.circles, editor.ids());
  const Change all = editor.all().value();
  EXPECT_EQ(numbers.vertices, all.addedVertices);
  EXPECT_EQ(snapshot.vertices, all.vertices);
  const auto idOf = [&](CircleIndex i) { return numbers.circles[static_cast<std::size_t>(i)]; };
  const auto numberOf = [&](VertexIndex v) {
    return v == kNone ? VertexIndex() : numbers.vertices[static_cast<std::size_t>(v)];
  };
  ASSERT_EQ(numbers.edges, all.addedEdges);
  for (std::size_t e = 0; e < snapshot.edges.size(); ++e) {
    const auto& [left, right, start, end] = snapshot.edges[e];
    EXPECT_EQ(all.edges[e], (Edge{idOf(left), idOf(right), numberOf(start), numberOf(end)}));
  }
  ASSERT_EQ(numbers.hiders.size(), all.hiders.size());
  EXPECT_FALSE(numbers.hiders.empty());
  for (std::size_t i = 0; i < numbers.hiders.size(); ++i) {
    EXPECT_EQ(all.hiders[i], (HiddenCircle{idOf(snapshot.hidden[i].circle), numbers.hiders[i]}));
  }
}

TEST(Editor, AnEditOfNothingChangesNothing) {
  DiagramEditor editor = editorOf(generate(Family::grid, 49, 1));
  const Change change = changeOf(editor.replace(20, *editor.circle(20)));
  EXPECT_TRUE(change.replaced.empty() && change.cells.empty() && change.removedVertices.empty() &&
              change.addedVertices.empty() && change.removedEdges.empty() && change.addedEdges.empty() &&
              change.circles.empty() && change.hiders.empty() && change.hullSides.empty());
  EXPECT_TRUE(changeOf(editor.apply({})).cells.empty());
}

TEST(Editor, GrowsByManyOrdersOfMagnitude) {
  Watched editor(generate(Family::uniform, 30, 1));
  for (const double size : {1e6, 1e9, 1e15, 1e20, 1e21, 1e28}) {
    for (int i = 0; i < 3; ++i) editor.insert({size, i * size, size / 4});
  }
  for (std::int32_t id = 47; id >= 30; --id) editor.remove(id);
}

TEST(Editor, APointFarAwayIsALocalEdit) {
  Watched editor(generate(Family::uniform, 300, 1));
  for (const double x : {1e20, 1e24, 7e28}) EXPECT_EQ(editor.insert({x, 0, 0}).way, EditWay::local);
  for (CircleId id = 0; id < 100; ++id) {
    Circle moved = *editor->circle(id);
    moved.r *= 1.5;
    editor.replace(id, moved);
    editor.remove(id + 100);
  }
  for (CircleId id = 300; id < 303; ++id) editor.remove(id);
}

TEST(Editor, ChangesHaveTheBitsOfTheSnapshotAtAnyScale) {
  const std::uint64_t seed = test::seedOr(1);
  for (std::uint64_t trial = 0; trial < 40; ++trial) {
    Random random(seed + trial);
    const auto any = [&](double size) {
      return Circle{size * random.unit(), size * random.unit(), 0.05 * size * random.unit()};
    };
    std::vector<Circle> circles;
    for (int i = 0; i < 12; ++i) circles.push_back(any(1));
    Watched editor(circles);
    for (int i = 0; i < 30; ++i) {
      SCOPED_TRACE("seed " + std::to_string(seed + trial) + ", edit " + std::to_string(i));
      // The scale of the diagram jumps, and later goes back.
      const Circle circle = any(random.below(2) == 0 ? 1 : random.logUniform(-28, 28));
      const std::vector<CircleId> ids = editor->ids();
      const CircleId id = ids[random.below(ids.size())];
      if (ids.size() < 12) {
        editor.insert(circle);
      } else if (random.below(2) == 0) {
        editor.remove(id);
      } else {
        editor.replace(id, circle);
      }
    }
  }
}

TEST(Editor, RoundsNumbersAsComputeDoes) {
  DiagramEditor editor = editorOf({{1e-300, 0x1.8p-96, 0}, {1, 0, 0}, {0, 1, -0.0}});
  EXPECT_EQ(*editor.circle(0), (Circle{0, 0x1p-95, 0}));
  const CircleId id = changeOf(editor.insert({0.1, 0x1.4p-94, 0x1p-98})).inserted.at(0);
  EXPECT_EQ(*editor.circle(id), (Circle{0.1, 0x1.4p-94, 0}));
  changeOf(editor.replace(id, {-0x1.fp-44, 5e-324, 0x1.cp-96}));
  EXPECT_EQ(*editor.circle(id), (Circle{-0x1.fp-44, 0, 0x1p-95}));
  expectRight(editor);
  EXPECT_EQ(editor.circles(), editor.snapshot().value().circles);
}

// Also a removal may leave circles that are all too small.
TEST(Editor, RefusesCirclesThatAreAllTooSmall) {
  EXPECT_EQ(DiagramEditor::from(std::vector<Circle>{{0, 1e-20, 0}}).error().code, ErrorCode::coordinateTooSmall);
  const Edit small = {Edit::Kind::insert, kNone, {0, 1e-20, 0}};
  const Edit large = {Edit::Kind::insert, kNone, {0, kSmallestInput, 0}};
  Watched points(std::vector<Circle>{{0, 0, 0}});
  EXPECT_EQ(points->apply({&small, 1}).error().code, ErrorCode::coordinateTooSmall);
  points.apply({small, large});
  points.apply({small});
  Watched editor({{1, 0, 0}, {1e-18, 0, 0}, {0, 1e-18, 0}});
  const Edit shrink = {Edit::Kind::replace, 0, {0, 0, 0}};
  for (const auto& refused : {editor->remove(0), editor->apply({&shrink, 1}), editor->replace(0, {0, 0, 1e-30})}) {
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::coordinateTooSmall);
  }
  editor.apply({{Edit::Kind::remove, 0, {}}, {Edit::Kind::insert, kNone, {0, 3, 0}}});
  editor.apply({{Edit::Kind::remove, 1, {}}, {Edit::Kind::remove, 2, {}}});
  editor.remove(3);
  EXPECT_EQ(editor->size(), 0U);
}

/// A number from the ends of the range: too small, the smallest, usual, the largest, zero.
double extremeNumber(Random& random) {
  constexpr double kSizes[] = {0x1p-110, 0x1p-97, 0x1p-90, 0x1p-57, kSmallestInput, 1, 0x1p90};
  if (random.below(3) == 0) return 0;
  return kSizes[random.below(std::size(kSizes))] * random.uniform(0.5, 1);
}

// One rule: an editor holds what `compute` takes, and refuses what `compute` refuses.
TEST(Editor, NeverHoldsWhatComputeRefuses) {
  const std::uint64_t seed = test::seedOr(1);
  int refused = 0;
  for (std::uint64_t trial = 0; trial < 300; ++trial) {
    Random random(seed * 1'000'003 + trial);
    DiagramEditor editor = editorOf({});
    for (int step = 0; step < 20; ++step) {
      std::vector<Edit> edits;
      std::vector<Circle> left;
      for (const CircleId id : editor.ids()) {
        const Edit::Kind kind = random.below(3) == 0 ? Edit::Kind::remove : Edit::Kind::replace;
        if (random.below(editor.size()) == 0) {
          edits.push_back({kind, id, {extremeNumber(random), extremeNumber(random), extremeNumber(random)}});
          if (kind == Edit::Kind::replace) left.push_back(edits.back().circle);
        } else {
          left.push_back(*editor.circle(id));
        }
      }
      if (edits.empty() || random.below(4) > 0) {
        left.push_back({extremeNumber(random), extremeNumber(random), extremeNumber(random)});
        edits.push_back({Edit::Kind::insert, kNone, left.back()});
      }
      const auto change = editor.apply(edits);
      SCOPED_TRACE("seed " + std::to_string(seed) + ", trial " + std::to_string(trial) + test::describe(left));
      if (!change.ok()) {
        ++refused;
        const auto computed = compute(left);
        ASSERT_FALSE(computed.ok());
        EXPECT_EQ(computed.error().code, change.error().code);
      }
      ASSERT_TRUE(compute(editor.circles()).ok());
      expectRight(editor);
      if (testing::Test::HasFailure()) return;
    }
  }
  EXPECT_GT(refused, 100);
}

TEST(Editor, FindsTheNearestCircle) {
  for (const Family family : {Family::uniform, Family::ring, Family::hidden, Family::collinear, Family::clustered}) {
    DiagramEditor editor = editorOf(generate(family, 400, 1));
    Random random(1);
    for (int i = 0; i < 200; ++i) changeOf(editor.remove(2 * i));
    for (int i = 0; i < 400; ++i) {
      const auto& circles = editor.circles();
      const Circle& near = circles[random.below(circles.size())];
      const Circle& far = circles[random.below(circles.size())];
      const Point p = {near.x + random.unit() * (far.x - near.x), near.y + random.unit() * (far.y - near.y)};
      const auto distance = [&](const Circle& c) { return std::hypot(c.x - p.x, c.y - p.y) - c.r; };
      double least = std::numeric_limits<double>::infinity();
      for (const Circle& c : circles) least = std::min(least, distance(c));
      const auto hint = static_cast<std::int32_t>(random.below(400));
      for (const CircleId id : {editor.nearest(p), editor.nearest(p, hint)}) {
        EXPECT_LE(distance(*editor.circle(id)), least + 1e-9 * (std::abs(least) + 1)) << familyName(family);
        EXPECT_FALSE(editor.isHidden(id));
      }
    }
  }
  DiagramEditor editor = editorOf({});
  EXPECT_EQ(editor.nearest({0, 0}), kNone);
  changeOf(editor.insert({1, 1, 1}));
  EXPECT_EQ(editor.nearest({5, 0}), 0);
  EXPECT_EQ(editor.nearest({std::numeric_limits<double>::quiet_NaN(), 0}), kNone);
}

}  // namespace
}  // namespace circle_voronoi
