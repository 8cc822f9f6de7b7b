// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>

#include "bit_cast.h"
#include "vectors.h"

namespace circle_voronoi {

/// Returns whether the differences of points, of which `largest` is the largest coordinate, are exact and below 2^kBits
/// times a power of two that divides them all. Then so few products and sums of them as fit in 53 bits are exact in
/// double arithmetic: it decides the ties of grids and other short numbers, which no error bound does. Those of short
/// lengths are of scaled differences (short_lengths.h).
template <int kBits>
bool haveShortDifferences(std::initializer_list<Point> points, double largest) {
  // A subnormal number has no leading bit in its exponent.
  if (!(largest >= 0x1p-1000)) return false;
  const double leading = bitCast<double>(bitCast<std::uint64_t>(largest) & 0x7ff0000000000000u);
  // The sum with a number below a third of this is rounded to a multiple of leading * 2^(1 - kBits).
  const double rounder = leading * (1.5 * static_cast<double>(std::uint64_t{1} << (53 - kBits)));
  const double limit = rounder / 3;
  const auto isShort = [=](double value) { return (value + rounder) - rounder == value && std::abs(value) <= limit; };
  return std::all_of(points.begin(), points.end(), [=](Point p) { return isShort(p.x) && isShort(p.y); });
}

}  // namespace circle_voronoi
