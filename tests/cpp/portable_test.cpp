// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the integers for compilers that have none of 128 bits with those of this compiler.
#include <gtest/gtest.h>

#include <compare>
#include <cstdint>
#include <type_traits>

#include "random.h"
#include "report.h"
#include "wide_integer.h"

namespace circle_voronoi {
namespace {

__extension__ using Signed = __int128;
__extension__ using Unsigned = unsigned __int128;

template <bool kIsSigned>
using Builtin = std::conditional_t<kIsSigned, Signed, Unsigned>;

template <bool kIsSigned>
Builtin<kIsSigned> builtin(const WideInteger<kIsSigned>& value) {
  const auto high = static_cast<std::uint64_t>(value >> 64), low = static_cast<std::uint64_t>(value);
  return static_cast<Builtin<kIsSigned>>(static_cast<Unsigned>(high) << 64 | low);
}

/// Returns a number of any length, of random bits or near a power of two.
template <bool kIsSigned>
WideInteger<kIsSigned> randomWide(Random& random) {
  using Wide = WideInteger<kIsSigned>;
  const auto bits = [&](std::size_t count) { return static_cast<std::uint64_t>(random.below(count)); };
  const int length = static_cast<int>(random.below(128));
  Wide value = Wide(1) << length;
  if (random.below(2) == 0) {
    for (int i = 0; i < length; ++i) value |= Wide(bits(2)) << i;
  } else {
    value = value + static_cast<int>(bits(3)) - 1;
  }
  return random.below(2) == 0 ? value : -value;
}

template <bool kIsSigned>
void compareWithBuiltin(Random& random) {
  using Same = Builtin<kIsSigned>;
  using Other = Builtin<!kIsSigned>;
  const auto a = randomWide<kIsSigned>(random), b = randomWide<kIsSigned>(random);
  const Same x = builtin(a), y = builtin(b);
  // Modulo 2^128, without the overflow of signed integers.
  const auto u = static_cast<Unsigned>(x), v = static_cast<Unsigned>(y);
  const int bits = static_cast<int>(random.below(128));
  EXPECT_TRUE(builtin(a + b) == static_cast<Same>(u + v));
  EXPECT_TRUE(builtin(a - b) == static_cast<Same>(u - v));
  EXPECT_TRUE(builtin(a * b) == static_cast<Same>(u * v));
  EXPECT_TRUE(builtin(-a) == static_cast<Same>(-u));
  EXPECT_TRUE(builtin(~a) == ~x);
  EXPECT_TRUE(builtin(a | b) == (x | y));
  EXPECT_TRUE(builtin(a << bits) == static_cast<Same>(u << bits));
  EXPECT_TRUE(builtin(a >> bits) == x >> bits);
  EXPECT_EQ(a < b, x < y);
  EXPECT_EQ(a > b, x > y);
  EXPECT_EQ(a == b, x == y);
  EXPECT_TRUE(a == a && a <= a && !(a < a));
  EXPECT_EQ(static_cast<std::uint64_t>(a), static_cast<std::uint64_t>(x));
  EXPECT_EQ(static_cast<std::int64_t>(a), static_cast<std::int64_t>(x));
  EXPECT_TRUE(builtin(WideInteger<!kIsSigned>(a)) == static_cast<Other>(x));
  if constexpr (kIsSigned) {
    if (y != 0 && y != -1) {
      EXPECT_TRUE(builtin(a / b) == x / y);
    }
  }
}

TEST(Portable, IntegersOf128BitsEqualThoseOfTheCompiler) {
  Random random(test::seedOr(1));
  for (int trial = 0; trial < 20000 && !::testing::Test::HasFailure(); ++trial) {
    compareWithBuiltin<true>(random);
    compareWithBuiltin<false>(random);
  }
}

TEST(Portable, IntegersOf64BitsKeepTheirValue) {
  for (const auto value : {std::int64_t{0}, std::int64_t{1}, std::int64_t{-1}, INT64_MIN, INT64_MAX}) {
    EXPECT_TRUE(builtin(WideInteger<true>(value)) == value);
    EXPECT_TRUE(builtin(WideInteger<false>(value)) == static_cast<Unsigned>(static_cast<Signed>(value)));
    EXPECT_TRUE(builtin(WideInteger<true>(static_cast<std::uint64_t>(value))) == static_cast<std::uint64_t>(value));
  }
}

}  // namespace
}  // namespace circle_voronoi
