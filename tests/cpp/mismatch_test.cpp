// SPDX-License-Identifier: GPL-3.0-or-later
// The rate at which the touching disc method differs from the exact diagram, by family and number of samples.
//
// Dynamic sampling may miss an antipodal disc; the table says how often. Samples added where the certificate failed
// mend nearly all mismatches. With every pair as a candidate, and by the automatic way, nothing may differ. The
// certificate must tell the right diagrams from the wrong ones. CIRCLE_VORONOI_SEED and CIRCLE_VORONOI_TRIALS choose
// other inputs.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>
#include <string>

#include "mismatches.h"

namespace circle_voronoi {
namespace {

std::uint64_t environmentOr(const char* name, std::uint64_t otherwise) {
  const char* value = std::getenv(name);
  return value == nullptr ? otherwise : std::strtoull(value, nullptr, 10);
}

std::string tableOf(const std::vector<test::Mismatches>& rows, std::uint64_t seed, std::uint64_t trials) {
  std::ostringstream table;
  table << "Percent of diagrams that differ from the exact one; " << trials << " inputs a family of 10 to 100 circles ("
        << "extreme: 5 to 14), seed " << seed << ".\n\n| family |";
  for (const test::ComparedWay& way : test::comparedWays()) table << " " << way.name << " |";
  table << "\n|---|";
  for (std::size_t way = 0; way < test::kComparedWays; ++way) table << "---|";
  table << "\n" << std::setprecision(3);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    table << "| " << families()[i].name << " |";
    for (std::size_t way = 0; way < test::kComparedWays; ++way) {
      if (test::comparedWays()[way].method == Method::touchingDisc &&
          test::isBeyondTouchingDisc(families()[i].family)) {
        table << " |";
      } else {
        table << " " << 100.0 * rows[i].wrong[way] / static_cast<double>(trials) << " |";
      }
    }
    table << "\n";
  }
  return table.str();
}

/// The largest percentage of inputs that may differ at N_s = 0, 1, 3 and resampled, for families where this is not 0.
/// It is a few times the percentage measured over several seeds, so that other seeds pass, too.
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

TEST(Mismatches, AreNoMoreThanEachFamilyAndNumberOfSamplesMayHave) {
  const std::uint64_t seed = environmentOr("CIRCLE_VORONOI_SEED", 1);
  const std::uint64_t trials = environmentOr("CIRCLE_VORONOI_TRIALS", 100);
  const std::vector<test::Mismatches> rows = test::countMismatches(seed, trials);

  const std::string table = tableOf(rows, seed, trials);
  std::cout << table;
  const std::filesystem::path report = CIRCLE_VORONOI_REPORT;
  std::filesystem::create_directories(report.parent_path());
  std::ofstream(report) << table;

  for (std::size_t i = 0; i < rows.size(); ++i) {
    const FamilyInfo& family = families()[i];
    EXPECT_EQ(rows[i].firstMisjudged, "");
    const auto limits = kMostPercent.find(family.family);
    for (std::size_t way = 0; way < test::kComparedWays; ++way) {
      const bool mayMiss = way < 4 && limits != kMostPercent.end();
      const double most = mayMiss ? limits->second[way] / 100 * static_cast<double>(trials) : 0;
      EXPECT_LE(rows[i].wrong[way], most) << rows[i].firstProblem[way];
    }
  }
}

}  // namespace
}  // namespace circle_voronoi
