// SPDX-License-Identifier: GPL-3.0-or-later
#include "mismatches.h"

#include <algorithm>
#include <atomic>
#include <set>
#include <thread>

#include "compare.h"
#include "oracle.h"

namespace circle_voronoi::test {
namespace {

const std::array<ComparedWay, kComparedWays> kWays = {{
    {Method::touchingDisc, Candidates::dynamic, 0, false, "N_s = 0"},
    {Method::touchingDisc, Candidates::dynamic, 1, false, "N_s = 1"},
    {Method::touchingDisc, Candidates::dynamic, 3, false, "N_s = 3"},
    {Method::touchingDisc, Candidates::dynamic, 0, true, "N_s = 0, resampled"},
    {Method::touchingDisc, Candidates::allPairs, -1, false, "all pairs"},
    {Method::automatic, Candidates::dynamic, -1, false, "auto"},
}};

Mismatches tryFamily(const FamilyInfo& family, std::uint64_t seed, std::uint64_t trials) {
  Mismatches found;
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    const auto circles = comparedInput(family.family, seed, trial);
    const Diagram exact = oracle::exactDiagram(circles);
    for (std::size_t way = 0; way < kWays.size(); ++way) {
      if (kWays[way].method == Method::touchingDisc && isBeyondTouchingDisc(family.family)) continue;
      Options options;
      options.method = kWays[way].method;
      options.candidates = kWays[way].candidates;
      options.samples = kWays[way].samples;
      options.resample = kWays[way].resample;
      const auto diagram = compute(circles, options);
      std::string problem;
      if (!diagram) {
        problem = diagram.error().message;
      } else if (family.isDegenerate) {
        problem = problemInDegeneratePosition(diagram.value(), exact, circles);
      } else {
        problem = problemInGeneralPosition(diagram.value(), exact, circles);
      }
      const std::string report = kWays[way].name + ": generate " + std::string(family.name) + " " +
                                 std::to_string(circles.size()) + " --seed " + std::to_string(seed + trial) + ": " +
                                 problem;
      const bool isCertified = diagram && diagram.value().certificate.certified();
      // In degenerate position rounding may choose vertices that are right after merging only; they have no
      // certificate.
      if (isCertified != problem.empty() && !(family.isDegenerate && !isCertified)) found.firstMisjudged = report;
      if (problem.empty()) continue;
      if (++found.wrong[way] == 1) found.firstProblem[way] = report;
      if (diagram && diagram.value().stats.counts.leftoverCycles == 1) ++found.passed[way];
    }
  }
  return found;
}

}  // namespace

std::span<const ComparedWay, kComparedWays> comparedWays() { return kWays; }

bool isBeyondTouchingDisc(Family family) {
  static const std::set<Family> kFamilies = {
      Family::twoClusters,   Family::farOutlier,     Family::longSpiral,      Family::growingLine, Family::tangentChain,
      Family::tangentInside, Family::tangentOutside, Family::tangentLine,     Family::commonPoint, Family::nearNested,
      Family::nestedTangent, Family::wedge,          Family::twoCommonPoints, Family::barelyOut};
  return kFamilies.contains(family);
}

std::vector<Circle> comparedInput(Family family, std::uint64_t seed, std::uint64_t trial) {
  const std::uint64_t inputSeed = seed + trial;
  const std::size_t count = family == Family::extreme ? 5 + inputSeed % 10 : 10 + inputSeed * 37 % 91;
  return generate(family, count, inputSeed);
}

std::vector<Mismatches> countMismatches(std::uint64_t seed, std::uint64_t trials) {
  std::vector<Mismatches> found(families().size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < found.size(); i = next++) found[i] = tryFamily(families()[i], seed, trials);
  };
  std::vector<std::jthread> threads;
  for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i) threads.emplace_back(work);
  threads.clear();  // waits for them
  return found;
}

}  // namespace circle_voronoi::test
