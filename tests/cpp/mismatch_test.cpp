// SPDX-License-Identifier: GPL-3.0-or-later
// How often the touching disc method differs from the exact diagram, by family and number of samples.
//
// Dynamic sampling may miss an antipodal disc; the table says how often. Samples added where the certificate failed
// mend all but a few of these. With every pair as a candidate, and by the automatic way, nothing may differ. The
// certificate must tell the right diagrams from the wrong ones. CIRCLE_VORONOI_SEED and CIRCLE_VORONOI_TRIALS choose
// other inputs.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <thread>

#include "circle_voronoi/compute.h"
#include "circle_voronoi/families.h"
#include "compare.h"
#include "oracle.h"

namespace circle_voronoi {
namespace {

std::uint64_t environmentOr(const char* name, std::uint64_t otherwise) {
  const char* value = std::getenv(name);
  return value == nullptr ? otherwise : std::strtoull(value, nullptr, 10);
}

struct Way {
  Method method;
  Candidates candidates;
  int samples;
  bool resample;
  std::string name;
};

const std::array<Way, 6> kWays = {{
    {Method::touchingDisc, Candidates::dynamic, 0, false, "N_s = 0"},
    {Method::touchingDisc, Candidates::dynamic, 1, false, "N_s = 1"},
    {Method::touchingDisc, Candidates::dynamic, 3, false, "N_s = 3"},
    {Method::touchingDisc, Candidates::dynamic, 0, true, "N_s = 0, resampled"},
    {Method::touchingDisc, Candidates::allPairs, -1, false, "all pairs"},
    {Method::automatic, Candidates::dynamic, -1, false, "auto"},
}};

/// Of these families all circles touch one disc or line, or nearly, and overlap, or are so far apart that rounding is
/// all that is left of a distance: in floating point the touching disc method gets discs in a wrong order with every
/// pair, so it is not asked.
bool isBeyondTouchingDisc(Family family) {
  static const std::set<Family> kFamilies = {Family::twoClusters,  Family::tangentInside, Family::tangentOutside,
                                             Family::tangentLine,  Family::commonPoint,   Family::nearNested,
                                             Family::nestedTangent};
  return kFamilies.contains(family);
}

/// What one family came to.
struct Row {
  std::array<int, kWays.size()> mismatches{};
  std::array<std::string, kWays.size()> firstProblem;
  std::string firstMisjudged;  ///< where the certificate and the comparison do not agree
};

Row tryFamily(const FamilyInfo& family, std::uint64_t seed, std::uint64_t trials) {
  Row row;
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    const std::uint64_t inputSeed = seed + trial;
    // The extreme family is meant for a few circles, the others for 10 to 100.
    const std::size_t count = family.family == Family::extreme ? 5 + inputSeed % 10 : 10 + inputSeed * 37 % 91;
    const auto circles = generate(family.family, count, inputSeed);
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
        problem = test::problemInDegeneratePosition(diagram.value(), exact, circles);
      } else {
        problem = test::problemInGeneralPosition(diagram.value(), exact, circles);
      }
      const std::string report = kWays[way].name + ": generate " + std::string(family.name) + " " +
                                 std::to_string(count) + " --seed " + std::to_string(inputSeed) + ": " + problem;
      const bool isCertified = diagram && diagram.value().certificate.certified();
      // In degenerate position rounding may choose vertices that are right after merging only; they have no
      // certificate.
      if (isCertified != problem.empty() && !(family.isDegenerate && !isCertified)) row.firstMisjudged = report;
      if (!problem.empty() && ++row.mismatches[way] == 1) row.firstProblem[way] = report;
    }
  }
  return row;
}

/// Works on the families in parallel.
std::vector<Row> tryFamilies(std::uint64_t seed, std::uint64_t trials) {
  std::vector<Row> rows(families().size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < rows.size(); i = next++) rows[i] = tryFamily(families()[i], seed, trials);
  };
  std::vector<std::jthread> threads;
  for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i) threads.emplace_back(work);
  threads.clear();  // waits for them
  return rows;
}

std::string tableOf(const std::vector<Row>& rows, std::uint64_t seed, std::uint64_t trials) {
  std::ostringstream table;
  table << "Percent of diagrams that differ from the exact one; " << trials << " inputs a family of 10 to 100 circles ("
        << "extreme: 5 to 14), seed " << seed << ".\n\n| family |";
  for (const Way& way : kWays) table << " " << way.name << " |";
  table << "\n|---|";
  for (std::size_t way = 0; way < kWays.size(); ++way) table << "---|";
  table << "\n" << std::setprecision(3);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    table << "| " << families()[i].name << " |";
    for (std::size_t way = 0; way < kWays.size(); ++way) {
      if (kWays[way].method == Method::touchingDisc && isBeyondTouchingDisc(families()[i].family)) {
        table << " |";
      } else {
        table << " " << 100.0 * rows[i].mismatches[way] / static_cast<double>(trials) << " |";
      }
    }
    table << "\n";
  }
  return table.str();
}

/// The most percent of inputs that may differ at N_s = 0, 1, 3 and resampled, where it is not none: a few times what
/// was measured over several seeds, so that another seed passes too.
const std::map<Family, std::array<double, 4>> kMostPercent = {
    {Family::logUniform, {3, 0.4, 0.4, 0.4}},
    {Family::mixed, {2, 0.4, 0.4, 0.4}},
    {Family::dense, {1, 0.4, 0.4, 0.4}},
    {Family::clustered, {1, 0.4, 0.4, 0.4}},
    {Family::chaosDisjoint, {1, 0.4, 0.4, 0.4}},
    {Family::oneHuge, {70, 4, 1, 0.4}},
    {Family::twoHuge, {2, 0.4, 0.4, 0.4}},
    {Family::extreme, {15, 0.6, 0.4, 0.4}},
    {Family::lightlyIntersecting, {2, 0.4, 0.4, 0.4}},
    {Family::intersecting, {4, 0.6, 0.6, 0.4}},
    {Family::hidden, {8, 1.2, 0.8, 0.4}},
    {Family::duplicates, {2, 0.4, 0.4, 0.4}},
    {Family::chaos, {12, 3, 1.2, 0.4}},
    {Family::farClusters, {3, 0.4, 0.4, 0.4}},
    {Family::outlier, {10, 0.4, 0.4, 0.4}},
    {Family::onRim, {1, 0.4, 0.4, 0.4}},
};

TEST(Mismatches, ByFamilyAndNumberOfSamples) {
  const std::uint64_t seed = environmentOr("CIRCLE_VORONOI_SEED", 1);
  const std::uint64_t trials = environmentOr("CIRCLE_VORONOI_TRIALS", 500);
  const std::vector<Row> rows = tryFamilies(seed, trials);

  const std::string table = tableOf(rows, seed, trials);
  std::cout << table;
  const std::filesystem::path report = CIRCLE_VORONOI_REPORT;
  std::filesystem::create_directories(report.parent_path());
  std::ofstream(report) << table;

  for (std::size_t i = 0; i < rows.size(); ++i) {
    const FamilyInfo& family = families()[i];
    EXPECT_EQ(rows[i].firstMisjudged, "");
    const auto limits = kMostPercent.find(family.family);
    for (std::size_t way = 0; way < kWays.size(); ++way) {
      const bool mayMiss = way < 4 && limits != kMostPercent.end();
      const double most = mayMiss ? limits->second[way] / 100 * static_cast<double>(trials) : 0;
      EXPECT_LE(rows[i].mismatches[way], most) << rows[i].firstProblem[way];
    }
  }
}

}  // namespace
}  // namespace circle_voronoi
