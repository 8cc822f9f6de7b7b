// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi_families/families.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>

#include "circle_voronoi/compute.h"
#include "fixtures.h"
#include "parameters.h"
#include "random.h"
#include "vectors.h"

namespace circle_voronoi {
namespace {

/// FNV-1a over the bits of all numbers.
std::uint64_t hashOf(const std::vector<Circle>& circles) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const Circle& c : circles) {
    for (const double value : {c.x, c.y, c.r}) {
      const auto bits = std::bit_cast<std::uint64_t>(value);
      for (int shift = 0; shift < 64; shift += 8) hash = (hash ^ ((bits >> shift) & 0xff)) * 0x100000001b3U;
    }
  }
  return hash;
}

/// The overlap of two circles, in units of the smaller radius.
double overlap(const Circle& a, const Circle& b) {
  const double depth = a.r + b.r - length(between(a, b));
  return depth <= 0 ? 0 : depth / std::min(a.r, b.r);
}

class FamilyTest : public testing::TestWithParam<std::string> {
 protected:
  const FamilyInfo& info() const { return *std::ranges::find(families(), GetParam(), &FamilyInfo::name); }
  std::vector<Circle> circles(std::size_t count, std::uint64_t seed) const {
    return generate(info().family, count, seed);
  }
};

std::vector<std::string> familyNames() {
  std::vector<std::string> names;
  for (const FamilyInfo& family : families()) names.emplace_back(family.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(All, FamilyTest, testing::ValuesIn(familyNames()), test::NameOfParameter());

TEST_P(FamilyTest, HasItsName) {
  EXPECT_EQ(familyName(info().family), GetParam());
  EXPECT_EQ(familyFromName(GetParam()), info().family);
}

TEST_P(FamilyTest, MakesExactlyAsManyCirclesAsAskedFor) {
  for (const std::size_t count : {0, 1, 2, 3, 4, 5, 10, 1000}) {
    const auto made = circles(count, 7);
    EXPECT_EQ(made.size(), count);
    for (const Circle& c : made) EXPECT_TRUE(std::isfinite(c.x) && std::isfinite(c.y) && c.r >= 0);
  }
}

TEST_P(FamilyTest, IsDisjointIfItSaysSo) {
  if (!info().isDisjoint) return;
  constexpr double kRounding = 1e-7;
  for (const std::size_t count : {2, 3, 7, 20, 300}) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const auto made = circles(count, seed);
      for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          ASSERT_LE(overlap(made[i], made[j]), kRounding)
              << count << " circles, seed " << seed << ": " << i << " " << j;
        }
      }
    }
  }
}

// The same bits on every platform: nothing may depend on a mathematical library, on the order of evaluation, or on the
// compiler. A change of a generator changes its hash, which belongs into the file.
TEST_P(FamilyTest, HasTheSameBitsEverywhere) {
  std::ifstream file(test::fileOfFixtures("family-hashes.json"));
  const auto hashes = nlohmann::json::parse(file);
  std::ostringstream hash;
  hash << std::hex << hashOf(circles(100, 42));
  EXPECT_EQ(hashes.value(GetParam(), ""), hash.str());
}

TEST(Families, AreListedInTheirOrderUnderDifferentNames) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < families().size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(families()[i].family), i);
    names.insert(families()[i].name);
  }
  EXPECT_EQ(names.size(), families().size());
  EXPECT_EQ(familyFromName("no such family"), std::nullopt);
}

TEST(Families, AnotherSeedGivesOtherCircles) {
  EXPECT_NE(generate(Family::uniform, 10, 1), generate(Family::uniform, 10, 2));
}

TEST(Families, DuplicatesHasCopiesAndConcentricCircles) {
  const auto circles = generate(Family::duplicates, 100, 1);
  int copies = 0;
  int concentric = 0;
  for (std::size_t i = 0; i < circles.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (circles[i] == circles[j])
        ++copies;
      else if (circles[i].x == circles[j].x && circles[i].y == circles[j].y)
        ++concentric;
    }
  }
  EXPECT_GT(copies, 5);
  EXPECT_GT(concentric, 5);
}

std::int64_t hiddenAmong(Family family, std::size_t count) {
  return compute(generate(family, count, 1)).value().stats.counts.hidden;
}

TEST(Families, ThoseThatNearlyHideOneAnotherAreVisible) {
  for (const Family family : {Family::tangentInside, Family::tangentOutside, Family::tangentLine, Family::commonPoint,
                              Family::nearNested, Family::cocircularLarge, Family::wedge, Family::twoCommonPoints,
                              Family::growingLine, Family::tangentChain, Family::barelyOut}) {
    EXPECT_EQ(hiddenAmong(family, 1000), 0) << familyName(family);
  }
}

TEST(Families, OfConcentricCirclesTheLargestIsVisible) { EXPECT_EQ(hiddenAmong(Family::concentric, 1000), 999); }

TEST(Families, OfNestedTangentCirclesMostAreHidden) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    EXPECT_GT(compute(generate(Family::nestedTangent, 1000, seed)).value().stats.counts.hidden, 900) << seed;
  }
}

TEST(Families, OutliersAndClustersAreAsFarAwayAsTheySay) {
  const auto inside = [](Family family, double low, double high) {
    return std::ranges::count_if(generate(family, 1000, 1), [&](const Circle& c) { return low <= c.x && c.x < high; });
  };
  EXPECT_EQ(inside(Family::twoClusters, -100, 100), 500);
  EXPECT_EQ(inside(Family::twoClusters, 1e12 - 100, 1e12 + 100), 500);
  EXPECT_EQ(inside(Family::outlier, 0, 100), 999);
  EXPECT_EQ(inside(Family::outlier, 1e9, 1.1e9), 1);
  EXPECT_EQ(inside(Family::farOutlier, 0, 100), 999);
  EXPECT_EQ(inside(Family::farOutlier, 1e28, 1.1e28), 1);
  EXPECT_EQ(inside(Family::farClusters, 2e6, 2e6 + 4.1e5), 200);
}

TEST(Random, PowersOfTenAreRightToRounding) {
  EXPECT_EQ(powerOfTen(0), 1);
  for (const double exponent : {-9.0, -3.3, -0.1, 0.5, 1.0, 4.7, 12.0}) {
    EXPECT_NEAR(powerOfTen(exponent) / std::pow(10, exponent), 1, 1e-14) << exponent;
  }
}

TEST(Random, DirectionsAreAnglesInTurns) {
  for (int i = -20; i <= 60; ++i) {
    const double turns = i / 37.0;
    const Vector v = directionAt(turns);
    EXPECT_NEAR(v.x, std::cos(2 * M_PI * turns), 2e-15) << turns;
    EXPECT_NEAR(v.y, std::sin(2 * M_PI * turns), 2e-15) << turns;
  }
  EXPECT_EQ(directionAt(0).x, 1);
  EXPECT_EQ(directionAt(0.25).y, 1);
  EXPECT_EQ(directionAt(0.5).x, -1);
}

TEST(Random, NumbersAreInTheirRangeAndSpreadOverIt) {
  Random random(1);
  double sum = 0;
  double squares = 0;
  for (int i = 0; i < 10000; ++i) {
    const double u = random.unit();
    ASSERT_TRUE(u >= 0 && u < 1);
    sum += u;
    const double g = random.gaussian();
    squares += g * g;
  }
  EXPECT_NEAR(sum / 10000, 0.5, 0.01);
  EXPECT_NEAR(squares / 10000, 1, 0.05);
}

}  // namespace
}  // namespace circle_voronoi
