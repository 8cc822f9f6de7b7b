// SPDX-License-Identifier: GPL-3.0-or-later
// Each way to a diagram on inputs that need it: where one stage takes over from another, only the way and the counts
// tell that the first has failed.
#include "construct.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "circle_voronoi/certify.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi_families/families.h"
#include "fixtures.h"
#include "report.h"
#include "tie_inputs.h"
#include "trace_replay.h"
#include "variants.h"

namespace circle_voronoi {
namespace {

struct WayCase {
  Way way;
  std::vector<Circle> circles;
  int repairs;
};

std::vector<WayCase> wayCases() {
  std::ifstream file(test::fileOfFixtures("ways.json"));
  std::vector<WayCase> cases;
  for (const auto& json : nlohmann::json::parse(file)) {
    const auto numbers = json["circles"].get<std::vector<std::array<double, 3>>>();
    auto& one = cases.emplace_back(WayCase{wayFromName(json["way"].get<std::string>()).value(), {}, json["repairs"]});
    for (const auto& [x, y, r] : numbers) one.circles.push_back({x, y, r});
  }
  return cases;
}

TEST(Construct, TakesEachWayWhereTheOnesBeforeFail) {
  const auto cases = wayCases();
  EXPECT_GE(cases.size(), 5U);
  for (const auto& [way, circles, repairs] : cases) {
    SCOPED_TRACE(wayName(way));
    const auto diagram = compute(circles);
    ASSERT_TRUE(diagram.ok()) << diagram.error().message;
    const Stats& stats = diagram.value().stats;
    EXPECT_EQ(stats.way, way);
    EXPECT_EQ(stats.counts.flips > 0, way != Way::flip);
    EXPECT_EQ(stats.counts.repairs, repairs);
    EXPECT_TRUE(certify(diagram.value()).value().certified());
    // A replay of the events gives the same diagram.
    test::Replay replay;
    replay.know(circles);
    Options told;
    told.observer = [&](const TraceEvent& event) { replay.see(event); };
    replay.expectDiagram(compute(circles, told).value(), test::firstIds(circles.size()));
    // Flips on their own end in another dual, and say so.
    Options options;
    options.method = Method::flip;
    EXPECT_EQ(compute(circles, options).value().certificate.certified(), way == Way::flip);
  }
}

/// The number of signs that were requested.
std::int64_t decisions(const Counts& counts) {
  return counts.filtered + counts.refined + counts.inCircle + counts.exact;
}

// Flips tell repair where they end wrong, and one judgment follows: no second look at all faces.
TEST(Construct, RepairCostsWhatItsPatchesCost) {
  const auto perCircle = [](std::uint64_t seed, Way way) {
    const Stats stats = compute(generate(Family::oneHuge, 1000, seed)).value().stats;
    EXPECT_EQ(stats.way, way);
    EXPECT_EQ(stats.counts.repairs, way == Way::repair);
    return decisions(stats.counts) / stats.counts.circles;
  };
  for (const std::uint64_t seed : {39, 398})
    EXPECT_LE(perCircle(seed, Way::repair), perCircle(1, Way::flip) + 2) << seed;
}

TEST(Construct, CountsTheSignsOfFlipsToo) {
  const std::vector<Circle> circles = generate(Family::uniform, 1000, 1);
  Options flip;
  flip.method = Method::flip;
  const Stats stats = compute(circles).value().stats;
  EXPECT_EQ(stats.way, Way::flip);
  EXPECT_EQ(decisions(stats.counts), decisions(compute(circles, flip).value().stats.counts));
}

// Where circles are 1e5 times smaller than their neighbor, doubles lose the lengths of their common tangents.
TEST(Construct, SignsBesideAHugeCircleRarelyNeedIntegers) {
  const Stats stats = compute(generate(Family::oneHuge, 20000, 1)).value().stats;
  EXPECT_LT(stats.counts.exact, stats.counts.circles / 100);
}

// Circles that barely stick out of one another: their common tangents are as short as doubles let them be.
TEST(Construct, NearTiesRarelyNeedIntegers) {
  const Stats stats = compute(generate(Family::nearNested, 2000, 1)).value().stats;
  EXPECT_GT(stats.counts.refined, stats.counts.circles);
  EXPECT_LT(stats.counts.exact, stats.counts.circles / 2);
}

TEST(Construct, CountsWhatInsertionTookWhereItToldTheHiddenCircles) {
  const Stats stats = compute(variants().back().make(Family::nearNested, 4000, 1)).value().stats;
  EXPECT_EQ(stats.way, Way::insert);
  EXPECT_GT(stats.counts.flips, 0);
  EXPECT_GT(decisions(stats.counts), stats.counts.circles);
}

TEST(Construct, AFlawIsOfTheCircleThatCertifyNames) {
  // The hidden circle comes first, so that all other circles have a different index among the visible ones.
  std::vector<Circle> circles = generate(Family::extreme, 40, 3);
  const Circle largest = *std::ranges::max_element(circles, {}, &Circle::r);
  circles.insert(circles.begin(), {largest.x, largest.y, largest.r / 2});
  Options options;
  options.method = Method::touchingDisc;
  options.samples = 0;
  const Diagram diagram = compute(circles, options).value();
  ASSERT_EQ(diagram.hidden.size(), 1U);
  ASSERT_EQ(diagram.certificate.flaw, Flaw::cellNotClosed);
  EXPECT_EQ(diagram.certificate.circle, certify(diagram).value().circle);
}

TEST(Construct, TakesMoreSamplesOnlyIfAskedTo) {
  const auto circles = test::readFixture("missed-antipodal-disc-log-uniform-4");
  Options options;
  options.method = Method::touchingDisc;
  options.samples = 0;
  const Diagram missed = compute(circles, options).value();
  EXPECT_FALSE(missed.certificate.certified());
  EXPECT_EQ(missed.stats.counts.resamplings, 0);
  options.resample = true;
  const Diagram found = compute(circles, options).value();
  EXPECT_TRUE(found.certificate.certified());
  EXPECT_EQ(found.stats.counts.resamplings, 1) << "one sample more in each angle is enough";
  EXPECT_GT(found.stats.counts.samples, missed.stats.counts.samples);
  EXPECT_EQ(found.stats.counts.repairs, 0);
}

// Flips alone make nearly all diagrams, and local repair nearly all of the rest. The other ways would hide it if they
// no longer did.
TEST(Construct, TheLaterWaysAreRare) {
  const std::uint64_t seed = test::seedOr(1);
  int trials = 0;
  int flip = 0;
  int repair = 0;
  const auto count = [&](const std::vector<Circle>& circles, std::string_view what) {
    const auto diagram = compute(circles);
    ASSERT_TRUE(diagram.ok()) << what << ": " << diagram.error().message << test::describe(circles);
    ++trials;
    flip += diagram.value().stats.way == Way::flip;
    repair += diagram.value().stats.way == Way::repair;
  };
  for (const FamilyInfo& family : families()) {
    // Near ties inside one circle, which flips from the triangulation of the centers often find no way through.
    if (family.family == Family::tangentInside || family.family == Family::nestedTangent ||
        family.family == Family::barelyOut) {
      continue;
    }
    for (std::uint64_t trial = 0; trial < 20; ++trial) {
      count(generate(family.family, 100, seed * 1'000 + trial), family.name);
    }
  }
  EXPECT_GE(flip, trials - 2);
  trials = flip = repair = 0;
  test::forEachTie(seed, 210, count);
  std::cout << trials << " near ties: " << flip << " by flips, " << repair << " by repair\n";
  EXPECT_GE(flip, trials * 95 / 100);
  EXPECT_GE(repair, (trials - flip) * 8 / 10);
}

TEST(Construct, EveryStageHasItsTime) {
  for (const auto& [way, circles, repairs] : wayCases()) {
    const Seconds seconds = compute(circles).value().stats.seconds;
    EXPECT_GT(seconds.order, 0);
    EXPECT_GT(seconds.triangulate, 0);
    EXPECT_GT(seconds.flip, 0);
    EXPECT_GT(seconds.certify, 0);
    EXPECT_EQ(seconds.repair > 0, way == Way::repair);
    EXPECT_GT(seconds.assemble, 0);
    double stages = 0;
    for (const auto& [name, member] : kSecondsMembers) stages += seconds.*member;
    EXPECT_GE(seconds.total, stages - seconds.total);
  }
}

}  // namespace
}  // namespace circle_voronoi
