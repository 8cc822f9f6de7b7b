// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "bit_cast.h"

namespace circle_voronoi {

/// Returns 2^exponent, for the exponents of normal numbers: std::ldexp without a call.
inline double powerOfTwo(int exponent) { return bitCast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52); }

/// Returns the exponent of the largest power of two that is not above a positive number, and -1 for zero: std::ilogb
/// without a call.
inline int exponentOf(double x) {
  if (x >= std::numeric_limits<double>::min()) return static_cast<int>(bitCast<std::uint64_t>(x) >> 52) - 1023;
  int exponent = 0;
  std::frexp(x, &exponent);
  return exponent - 1;
}

/// Estimates of lengths below this are computed from scaled lengths. Products of longer lengths do not underflow by an
/// amount that matters (kUnderflowError).
inline constexpr double kShortLength = 0x1p-20;

/// Returns the power of two that brings a length into [1, 2), but at most 2^900.
///
/// An estimate may multiply all lengths by it. This is exact: none of them exceeds `largest`, so nothing overflows, and
/// a subnormal number becomes a normal one or stays exact. Lengths below 2 satisfy what kUnderflowError assumes.
inline double scaleOf(double largest) {
  constexpr int kMost = 900;
  const int scaling = -exponentOf(largest);
  return powerOfTwo(scaling < kMost ? scaling : kMost);
}

}  // namespace circle_voronoi
