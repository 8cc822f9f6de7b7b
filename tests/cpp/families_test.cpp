// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi_families/families.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "circle_voronoi/compute.h"
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
// compiler. A change of a generator changes its hash; write the new one here.
TEST_P(FamilyTest, HasTheSameBitsEverywhere) {
  static const std::map<std::string_view, std::uint64_t> kHashes = {
      {"uniform", 0xf6443affb480717fU},
      {"log-uniform", 0x1c73c55019e7f39eU},
      {"points", 0x54ac298299012a43U},
      {"mixed", 0xa6c01f5d163c6857U},
      {"dense", 0x9eeebc7aa62049cbU},
      {"clustered", 0x23a180118ddae3b8U},
      {"spiral", 0xa04b29290f55c2c4U},
      {"chaos-disjoint", 0xbf42f8ec3e11fd97U},
      {"far-from-origin", 0x27631567e7ceab3dU},
      {"tiny", 0xe830d38e43f26034U},
      {"one-huge", 0x791d329eda578841U},
      {"two-huge", 0xebbbbbab4346566aU},
      {"ring", 0xa98e100e7163f571U},
      {"ring-varied", 0xc48246797be35508U},
      {"rows", 0x5acc7cd53fb659f4U},
      {"extreme", 0xef12bdbf0a9cdbe5U},
      {"lightly-intersecting", 0x9db552885e06a092U},
      {"intersecting", 0x43eba1e6c075f0c6U},
      {"hidden", 0x7c2da3216b1a4698U},
      {"duplicates", 0xe30185c08b825789U},
      {"chaos", 0xb93bd0c064b6773eU},
      {"collinear", 0x2eb3c698f1986b3dU},
      {"collinear-varied", 0x90be96f7b033645eU},
      {"near-collinear", 0x8f2db0f3d0f0e5a4U},
      {"grid", 0x6ce37e01a069e61dU},
      {"grid-tangent", 0xd44f20a8977ad95dU},
      {"grid-columns", 0x9406db14007dbff1U},
      {"hexagonal", 0x7a2f5e619fc14e4U},
      {"cocircular-varied", 0xb564c7f39be0ab87U},
      {"cocircular-equal", 0x56f0d1a48b07b698U},
      {"two-clusters", 0xaf861088219362b5U},
      {"far-clusters", 0xd07ba1888649e038U},
      {"outlier", 0x1b899cbfe5e5ef71U},
      {"line-and-huge", 0xc50b35feea7460dbU},
      {"far-outlier", 0x8d21a4dd287d39f9U},
      {"long-spiral", 0x99a5e071d58b4737U},
      {"growing-line", 0x8c2922bc56506cb6U},
      {"tangent-chain", 0x47a845c60789a8d2U},
      {"tangent-inside", 0xe880236f4cbb5de1U},
      {"tangent-outside", 0xdb7bc695a4f18abcU},
      {"tangent-line", 0x1bc175ce7a5582d7U},
      {"common-point", 0x2445406e5e36b170U},
      {"near-nested", 0xf926f15427c0c569U},
      {"nested-tangent", 0x93e0d765d5469f18U},
      {"concentric", 0xcf2c5fa0a8972246U},
      {"cocircular-large", 0x3fdbc4189184bdc7U},
      {"on-rim", 0xdace973dd328e81aU},
      {"wedge", 0xb828053bd645301fU},
      {"two-common-points", 0x461032f657304e0aU},
      {"barely-out", 0x3e25f4bc6a5bb6acU},
  };
  const std::uint64_t hash = hashOf(circles(100, 42));
  const auto expected = kHashes.find(GetParam());
  ASSERT_NE(expected, kHashes.end()) << "{\"" << GetParam() << "\", 0x" << std::hex << hash << "U},";
  EXPECT_EQ(hash, expected->second) << std::hex << hash;
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
