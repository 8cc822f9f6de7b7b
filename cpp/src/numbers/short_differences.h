// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>

#include "bit_cast.h"
#include "vectors.h"

namespace circle_voronoi {

/// Returns whether the differences of points are exact and below 2^kBits times a power of two that divides them all.
/// `largest` is the largest coordinate of the differences. Then their products and sums are exact in double arithmetic
/// as long as the results fit in 53 bits. This decides the ties of grids and other short numbers, which no error bound
/// does.
template <int kBits>
bool haveShortDifferences(std::initializer_list<Point> points, double largest) {
  if (!(largest > 0)) return false;
  const double leading = leadingBit(largest);
  // If a number is below a third of `rounder`, the sum of both is rounded to a multiple of leading * 2^(1 - kBits).
  const double rounder = leading * (1.5 * static_cast<double>(std::uint64_t{1} << (53 - kBits)));
  const double limit = rounder / 3;
  const auto isShort = [=](double value) { return (value + rounder) - rounder == value && std::abs(value) <= limit; };
  return std::all_of(points.begin(), points.end(), [=](Point p) { return isShort(p.x) && isShort(p.y); });
}

}  // namespace circle_voronoi
