// SPDX-License-Identifier: GPL-3.0-or-later
#include "threads.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "centers.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/editor.h"
#include "circle_voronoi_families/families.h"
#include "delaunay.h"
#include "dual_edits.h"
#include "found_sites.h"
#include "judge.h"
#include "order.h"
#include "validate.h"

namespace circle_voronoi {
namespace {

/// All kinds of work are shared out from this number of circles on.
constexpr std::size_t kCircles = 3000;

TEST(Threads, CallEachTaskOnce) {
  for (const int count : {1, 2, 3, 8}) {
    const Threads threads(count);
    std::vector<std::atomic<int>> calls(100);
    threads.run(calls.size(), [&](std::size_t i) { ++calls[i]; });
    for (const auto& of : calls) EXPECT_EQ(of, 1) << count;
  }
}

TEST(Threads, ShareOutAllItemsInSuccession) {
  for (const int count : {1, 2, 3, 8}) {
    const Threads threads(count);
    for (const std::size_t items : {0, 1, 1023, 1024, 2048, 10'007, 100'000}) {
      std::vector<std::size_t> ends(threads.rangesOf(items));
      std::vector<std::size_t> begins(ends.size());
      threads.forRanges(items, [&](std::size_t begin, std::size_t end, std::size_t range) {
        begins[range] = begin;
        ends[range] = end;
      });
      EXPECT_EQ(begins.front(), 0U);
      EXPECT_EQ(ends.back(), items);
      for (std::size_t range = 1; range < ends.size(); ++range) EXPECT_EQ(begins[range], ends[range - 1]);
      EXPECT_EQ(ends.size() > 1, count > 1 && items >= 2048) << count << " threads, " << items << " items";
    }
  }
}

TEST(Threads, FindTheFirstItem) {
  for (const int count : {1, 2, 8}) {
    const Threads threads(count);
    for (const std::size_t first : {0, 5000, 49'999, 50'000}) {
      EXPECT_EQ(threads.firstWhere(50'000, [&](std::size_t i) { return i >= first; }), first);
    }
  }
}

TEST(Threads, PassOnWhatATaskThrows) {
  for (const int count : {1, 2, 8}) {
    const auto fail = [](std::size_t i) {
      if (i == 7) throw std::runtime_error("seven");
    };
    EXPECT_THROW(Threads(count).run(100, fail), std::runtime_error) << count;
  }
}

TEST(Threads, AreAtLeastOne) {
  EXPECT_GE(Threads(0).count(), 1);
  EXPECT_EQ(Threads().count(), 1);
}

auto countsOf(const Stats& stats) {
  const Counts& c = stats.counts;
  return std::tuple(stats.way, c.circles, c.hidden, c.samples, c.antipodalDiscs, c.threeTouchDiscs, c.events,
                    c.leftoverCycles, c.resamplings, c.flips, c.repairs, c.filtered, c.refined, c.inCircle, c.exact);
}

void expectSameBits(const Diagram& actual, const Diagram& expected, const std::string& about) {
  ASSERT_EQ(actual.vertices.size(), expected.vertices.size()) << about;
  // An empty vector may have no memory.
  if (!expected.vertices.empty()) {
    const std::size_t size = expected.vertices.size() * sizeof(Vertex);
    EXPECT_EQ(std::memcmp(actual.vertices.data(), expected.vertices.data(), size), 0) << about;
  }
  EXPECT_EQ(actual.vertexCircles, expected.vertexCircles) << about;
  EXPECT_EQ(actual.edges, expected.edges) << about;
  EXPECT_EQ(actual.hidden, expected.hidden) << about;
  EXPECT_EQ(actual.hull, expected.hull) << about;
  EXPECT_EQ(actual.links, expected.links) << about;
  EXPECT_EQ(actual.certificate.flaw, expected.certificate.flaw) << about;
  EXPECT_EQ(actual.certificate.message, expected.certificate.message) << about;
  EXPECT_EQ(countsOf(actual.stats), countsOf(expected.stats)) << about;
}

void expectSameBitsInThreads(Family family, Options options) {
  const auto circles = generate(family, kCircles, 1);
  const auto expected = compute(circles, options);
  for (const int threads : {2, 3, 8}) {
    options.threads = threads;
    const auto actual = compute(circles, options);
    ASSERT_EQ(actual.ok(), expected.ok());
    const std::string about = std::string(familyName(family)) + ", " + std::to_string(threads) + " threads";
    if (expected) expectSameBits(actual.value(), expected.value(), about);
  }
}

TEST(Compute, HasTheSameBitsInAnyNumberOfThreads) {
  for (const FamilyInfo& family : families()) expectSameBitsInThreads(family.family, {});
}

// Where flips alone do not lead to the diagram, its certificate names the same flaw.
TEST(Compute, HasTheSameBitsByFlipsInThreads) {
  Options options;
  options.method = Method::flip;
  for (const Family family : {Family::uniform, Family::tangentInside, Family::barelyOut, Family::commonPoint}) {
    expectSameBitsInThreads(family, options);
  }
}

TEST(Compute, HasTheSameBitsByTheTouchingDiscMethodInThreads) {
  Options options;
  options.method = Method::touchingDisc;
  expectSameBitsInThreads(Family::uniform, options);
}

TEST(Editor, HasTheSameBitsInAnyNumberOfThreads) {
  const auto circles = generate(Family::hidden, kCircles, 1);
  const auto movedBy = [](DiagramEditor editor, std::span<const Circle> all) {
    // A batch of this size computes the whole diagram.
    std::vector<Edit> edits;
    for (std::size_t i = 0; i < all.size(); i += 2) {
      edits.push_back({Edit::Kind::replace, static_cast<std::int32_t>(i), {all[i].x + 0.5, all[i].y, all[i].r}});
    }
    EXPECT_EQ(editor.apply(edits).value().way, EditWay::whole);
    return editor.snapshot();
  };
  const auto one = movedBy(DiagramEditor::from(circles).value(), circles);
  for (const int threads : {2, 4}) {
    expectSameBits(movedBy(DiagramEditor::from(circles, {.threads = threads}).value(), circles).value(), one.value(),
                   std::to_string(threads));
  }
  const auto refused = DiagramEditor::from(circles, {.threads = -1});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::badOption);
}

TEST(Compute, CanBeCancelledInThreads) {
  Options options;
  options.threads = 3;
  const auto circles = generate(Family::uniform, kCircles, 1);
  for (const Stage last : {Stage::order, Stage::triangulate, Stage::flip, Stage::certify, Stage::assemble}) {
    options.progress = [&](Stage stage, double) {
      if (stage == last) throw std::runtime_error("cancelled");
    };
    EXPECT_THROW((void)compute(circles, options), std::runtime_error);
  }
}

TEST(Compute, RefusesFewerThreadsThanNone) {
  Options options;
  options.threads = -1;
  const auto result = compute({}, options);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::badOption);
}

// Points that coincide leave some numbers of corners and faces free.
TEST(Delaunay, IsTheSameInAnyNumberOfThreads) {
  std::vector<std::vector<Point>> inputs;
  for (const Family family : {Family::uniform, Family::grid, Family::collinear, Family::duplicates, Family::concentric,
                              Family::cocircularEqual, Family::longSpiral}) {
    inputs.push_back(centersOf(generate(family, kCircles, 1)));
  }
  inputs.emplace_back(kCircles, Point{1, 2});
  inputs.emplace_back(kCircles, Point{1, 2});
  for (std::size_t i = 0; i < kCircles; i += 2) inputs.back()[i] = {3, static_cast<double>(i % 10)};
  for (const auto& points : inputs) {
    const Delaunay expected = delaunay(points);
    for (const int count : {2, 3, 8}) {
      const Delaunay actual = delaunay(points, Threads(count));
      EXPECT_EQ(actual.dual.origin, expected.dual.origin);
      EXPECT_EQ(actual.dual.twin, expected.dual.twin);
      EXPECT_EQ(actual.representative, expected.representative);
    }
  }
}

TEST(Judge, NamesTheSameTiesInAnyNumberOfThreads) {
  const std::vector<Circle> circles = generate(Family::grid, 2'500, 1);
  const Dual dual = test::dualOf(compute(circles).value(), circles.size());
  const auto tiesWith = [&](int threads) {
    Predicates predicates(circles);
    return judge(circles, dual, predicates, {}, Threads(threads)).ties;
  };
  const std::vector<int> ties = tiesWith(1);
  EXPECT_GT(ties.size(), 1'000U);
  for (const int threads : {2, 4}) EXPECT_EQ(tiesWith(threads), ties) << threads;
}

TEST(Hide, IsTheSameInAnyNumberOfThreads) {
  for (const Family family : {Family::hidden, Family::duplicates, Family::nearNested}) {
    const auto circles = validate(generate(family, 2 * kCircles, 1)).value();
    const Sites expected = test::foundSites(order(circles)).sites;
    for (const int count : {2, 8}) {
      const Sites actual = test::foundSites(order(circles, Threads(count)), Threads(count)).sites;
      EXPECT_EQ(actual.indices, expected.indices);
      EXPECT_EQ(actual.hidden, expected.hidden);
      EXPECT_EQ(actual.steps, expected.steps);
    }
  }
}

}  // namespace
}  // namespace circle_voronoi
