// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "bit_cast.h"

namespace circle_voronoi {

/// Estimates of shorter lengths are computed from scaled ones. Products of longer ones do not underflow by an amount
/// that matters (kUnderflowError).
inline constexpr double kShortLength = 0x1p-20;

/// Returns the power of two that brings a length into [1, 2), but at most 2^900.
///
/// An estimate may multiply all lengths by it. This is exact: none of them exceeds `largest`, so nothing overflows, and
/// a subnormal number becomes a normal one or stays exact. Lengths below 2 satisfy what kUnderflowError assumes.
inline double scaleOf(double largest) {
  constexpr int kBias = 1023;
  constexpr int kMost = 900;
  const int exponent = static_cast<int>(bitCast<std::uint64_t>(largest) >> 52) - kBias;
  const int scaling = -exponent < kMost ? -exponent : kMost;
  return bitCast<double>(static_cast<std::uint64_t>(kBias + scaling) << 52);
}

}  // namespace circle_voronoi
