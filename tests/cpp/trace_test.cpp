// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "circle_voronoi/compute.h"
#include "circle_voronoi_families/families.h"
#include "random.h"
#include "report.h"

namespace circle_voronoi {
namespace {

struct Traced {
  Diagram diagram;
  std::vector<TraceEvent> events;

  std::int64_t count(TraceKind kind) const {
    return std::ranges::count(events, kind, [](const TraceEvent& event) { return event.kind; });
  }
};

Traced trace(const std::vector<Circle>& circles, Options options = {}) {
  Traced result;
  options.method = Method::touchingDisc;
  options.observer = [&](const TraceEvent& event) { result.events.push_back(event); };
  result.diagram = compute(circles, options).value();
  return result;
}

TEST(Trace, TellsOfEveryCandidate) {
  const std::vector<Circle> circles = generate(Family::intersecting, 60, 3);
  for (const Candidates candidates : {Candidates::dynamic, Candidates::uniform, Candidates::allPairs}) {
    Options options;
    options.candidates = candidates;
    const Traced traced = trace(circles, options);
    const Counts& counts = traced.diagram.stats.counts;
    const std::vector<TraceEvent>& events = traced.events;
    const bool isSampled = candidates != Candidates::allPairs;
    EXPECT_EQ(events.at(0).kind, TraceKind::roundBegun);
    EXPECT_EQ(events.at(0).numbers[0], 0);
    EXPECT_EQ(traced.count(TraceKind::roundBegun), 1);
    // A triangulation has 3 n - 3 edges less the number of hull edges.
    const auto edgesAmong = [](const std::vector<Circle>& points) {
      const Diagram diagram = compute(points).value();
      const std::size_t visible = points.size() - diagram.hidden.size();
      return static_cast<std::int64_t>(3 * visible - 3 - diagram.hull.size());
    };
    std::vector<Circle> centers;
    for (CircleIndex i = 0; i < static_cast<std::int32_t>(circles.size()); ++i) {
      const Circle& c = circles[static_cast<std::size_t>(i)];
      if (traced.diagram.hasCell(i)) centers.push_back({c.x, c.y, 0});
    }
    EXPECT_EQ(traced.count(TraceKind::centersJoined), candidates == Candidates::dynamic ? edgesAmong(centers) : 0);
    EXPECT_EQ(traced.count(TraceKind::sampleTaken), counts.samples);
    std::vector<Circle> samples;
    std::set<std::set<CircleIndex>> joined;
    std::set<std::set<CircleIndex>> found;
    for (const TraceEvent& event : events) {
      const std::set<CircleIndex> pair = {event.circles[0], event.circles[1]};
      if (event.kind == TraceKind::sampleTaken) samples.push_back({event.disc.x, event.disc.y, 0});
      if (event.kind == TraceKind::samplesJoined && pair.size() == 2) joined.insert(pair);
      if (event.kind == TraceKind::pairFound) found.insert(pair);
    }
    EXPECT_EQ(traced.count(TraceKind::samplesJoined), isSampled ? edgesAmong(samples) : 0);
    EXPECT_TRUE(!isSampled || found == joined) << "circles with neighboring samples are the pairs";
    EXPECT_EQ(traced.count(TraceKind::pairFound), counts.antipodalDiscs);
    EXPECT_EQ(traced.count(TraceKind::threeTouchDiscFormed), counts.threeTouchDiscs);
    std::vector<CircleIndex> circleOfSample;
    for (const TraceEvent& event : events) {
      if (event.kind == TraceKind::sampleTaken) circleOfSample.push_back(event.circles[0]);
      if (event.kind != TraceKind::samplesJoined) continue;
      for (const int k : {0, 1}) {
        ASSERT_EQ(event.circles[k], circleOfSample.at(static_cast<std::size_t>(event.numbers[k])));
      }
    }
  }
}

// With the numbers of events alone one can tell which of several directed edges between two circles is meant.
TEST(Trace, OfEveryFamilyIsConsistent) {
  const std::uint64_t seed = test::seedOr(1);
  for (const FamilyInfo& family : families()) {
    SCOPED_TRACE(std::string(family.name) + ", seed " + std::to_string(seed));
    const auto [diagram, events] = trace(generate(family.family, 3 + Random(seed).below(80), seed));
    std::map<std::int32_t, std::array<CircleIndex, 2>> alive;
    std::set<std::array<std::int32_t, 2>> waiting;
    std::int32_t placed = 0;
    std::int32_t made = 0;
    for (const TraceEvent& event : events) {
      const auto& [a, b, c] = event.circles;
      const auto& [first, second] = event.numbers;
      switch (event.kind) {
        case TraceKind::directedEdgePlaced:
          ASSERT_EQ(first, placed++);
          alive[first] = {a, b};
          break;
        case TraceKind::segmentFinished:
          ASSERT_EQ(event.vertex, made - 1);
          ASSERT_TRUE(alive.contains(first));
          break;
        case TraceKind::directedEdgeDeleted:
          ASSERT_EQ(alive.at(first), (std::array{a, b}));
          alive.erase(first);
          break;
        case TraceKind::threeTouchDiscFormed:
          ASSERT_EQ(alive.at(first), (std::array{a, b}));
          ASSERT_EQ(alive.at(second), (std::array{b, c}));
          ASSERT_TRUE(waiting.insert(event.numbers).second);
          break;
        case TraceKind::branchDisc:
          ASSERT_EQ(event.vertex, made++);
          ASSERT_EQ(alive.at(first), (std::array{a, b}));
          ASSERT_EQ(waiting.erase(event.numbers), 1U);
          break;
        case TraceKind::threeTouchDiscStale:
          ASSERT_EQ(waiting.erase(event.numbers), 1U);
          break;
        default:
          break;
      }
    }
    EXPECT_TRUE(waiting.empty());
    EXPECT_EQ(static_cast<std::size_t>(made), diagram.vertices.size());
  }
}

TEST(Trace, TheFarthestDiscsAreFinite) {
  const double limit = kCoordinateLimit;
  const std::vector<Circle> circles = {
      {-limit, 0, 0}, {limit, 0, 0}, {limit / 2, kCoordinateStep, 0}, {-limit / 2, limit / 3, limit / 4}};
  double largest = 0;
  Options options;
  options.observer = [&](const TraceEvent& event) {
    const auto& [x, y, r] = event.disc;
    EXPECT_FALSE(std::isinf(x) || std::isinf(y) || std::isinf(r));
    EXPECT_EQ(std::isnan(x) || std::isnan(y), std::isnan(r));
    if (event.kind == TraceKind::faceMade && !std::isnan(r)) largest = std::max(largest, std::abs(r));
  };
  EXPECT_TRUE(compute(circles, options).value().certificate.certified());
  EXPECT_GT(largest, 0x1p280);
}

TEST(Trace, EachKindHasAName) {
  std::set<std::string_view> names;
  for (int kind = 0; kind <= static_cast<int>(TraceKind::circleShrunk); ++kind) {
    EXPECT_TRUE(names.insert(traceKindName(static_cast<TraceKind>(kind))).second);
  }
  EXPECT_FALSE(names.contains(""));
}

}  // namespace
}  // namespace circle_voronoi
