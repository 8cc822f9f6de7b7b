// SPDX-License-Identifier: GPL-3.0-or-later
// Compares our integers with the integers of a library, at the last bit of each width.
#include "integer.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "random.h"
#include "report.h"

namespace circle_voronoi {
namespace {

using Reference = boost::multiprecision::cpp_int;

/// A number near the largest magnitude with a number of bits, or below.
limbs::SignedWide randomWide(Random& random, int bits) {
  limbs::SignedWide value = 0;
  const std::size_t kind = random.below(3);
  if (kind == 0) value = (limbs::SignedWide{1} << bits) - 1 - static_cast<int>(random.below(3));
  if (kind == 1) value = limbs::SignedWide{1} << static_cast<int>(random.below(static_cast<std::size_t>(bits)));
  for (int i = 0; kind == 2 && i < bits; ++i) value = value << 1 | static_cast<int>(random.below(2));
  return random.below(2) == 0 ? value : -value;
}

Reference referenceOf(limbs::SignedWide value) {
  const bool isNegative = value < 0;
  const auto magnitude = static_cast<limbs::Wide>(isNegative ? -value : value);
  Reference result = static_cast<limbs::Limb>(magnitude >> 64);
  result = (result << 64) + static_cast<limbs::Limb>(magnitude);
  return isNegative ? Reference(-result) : result;
}

/// The same number by its leading bits and its sign.
template <class Number>
void expectSame(const Number& number, const Reference& reference) {
  ASSERT_EQ(number.sign(), reference.sign());
  const auto [value, exponent] = number.leading();
  if (reference.is_zero()) {
    EXPECT_EQ(value, 0);
    return;
  }
  const Reference magnitude = abs(reference);
  const int scaling = static_cast<int>(msb(magnitude)) - 63;
  const Reference top = scaling >= 0 ? Reference(magnitude >> scaling) : Reference(magnitude << -scaling);
  const double expected = reference.sign() * static_cast<double>(static_cast<std::uint64_t>(top));
  EXPECT_NEAR(std::ldexp(value, exponent - scaling) / expected, 1, 0x1p-51);
}

/// A form of degree eight with the same number of terms as the forms of exact.cpp, at their largest values.
template <class Number>
auto coneOfNormal(const Number& a, const Number& b, const Number& c) {
  const auto g = a * a + b * b - c * c;
  const auto x = g * (a * b - b * c) + g * (b * c - c * a) + g * (c * a - a * b) + g * (a * c);
  const auto y = g * (a * a - b * c) + g * (b * b + c * a);
  return x * x + y * y - (x - y) * (x + y);
}

template <class Number, class Convert>
void compare(Random& random, int bits, Convert convert) {
  for (int trial = 0; trial < 1000; ++trial) {
    const limbs::SignedWide a = randomWide(random, bits), b = randomWide(random, bits), c = randomWide(random, bits);
    const Number x = convert(a), y = convert(b), z = convert(c);
    const Reference p = referenceOf(a), q = referenceOf(b), r = referenceOf(c);
    expectSame(x, p);
    expectSame(-x, -p);
    expectSame(x * y - y * x, Reference(0));
    expectSame(x * y - z * x, Reference(p * q - r * p));
    expectSame((x * x + y * y) * z, Reference((p * p + q * q) * r));
    expectSame(coneOfNormal(x, y, z), Reference(coneOfNormal(p, q, r)));
  }
}

TEST(Integer, OfOneLimbIsRightToItsLastBit) {
  Random random(test::seedOr(1));
  compare<FixedInteger<1>>(random, 61, [](limbs::SignedWide value) { return FixedInteger<1>(value); });
}

TEST(Integer, OfTwoLimbsIsRightToItsLastBit) {
  Random random(test::seedOr(1));
  compare<FixedInteger<2>>(random, 125, [](limbs::SignedWide value) { return FixedInteger<2>(value); });
}

TEST(Integer, OfFourLimbsIsRightFromTheStepToTheLimitOfNumbers) {
  Random random(test::seedOr(1));
  for (const int shift : {0, 1, 63, 64, 65, 127, 128, 129, 140, 192, 200}) {
    for (int trial = 0; trial < 100; ++trial) {
      const auto a = static_cast<std::int64_t>(randomWide(random, 53));
      const auto b = static_cast<std::int64_t>(randomWide(random, 53));
      const FixedInteger<4> x(b, 0);
      const FixedInteger<4> y(a, shift);
      const Reference p = b;
      Reference q = a;
      q <<= shift;
      expectSame(y, q);
      expectSame(x - y, Reference(p - q));
      expectSame((x + y) - y, p);
      expectSame(y * y - y * y, Reference(0));
      if (shift <= 192) expectSame(coneOfNormal(x, y, y - x), Reference(coneOfNormal(p, q, Reference(q - p))));
    }
  }
}

}  // namespace
}  // namespace circle_voronoi
