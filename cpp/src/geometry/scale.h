// SPDX-License-Identifier: GPL-3.0-or-later
// Lengths from the smallest to the largest double, whose products neither overflow nor vanish.
#pragma once

#include <algorithm>
#include <cmath>

#include "infinity.h"
#include "vectors.h"

namespace circle_voronoi {

/// Parameters of curves and places on them may be off by that share, by rounding.
inline constexpr double kRounding = 0x1p-40;
/// The finest polyline of a curve, as a share of its size.
inline constexpr double kFinestPolyline = 1e-9;

inline Vector vectorTo(Point p, Point q) { return {q.x - p.x, q.y - p.y}; }

/// Whether a sum of two products has neither overflown nor lost what counts.
inline bool isSafe(double product) { return 0x1p-900 < std::abs(product) && std::abs(product) < 0x1p1000; }

/// The largest power of two up to `size` > 0.
inline double powerOfTwoIn(double size) {
  int exponent = 0;
  std::frexp(size, &exponent);
  return std::ldexp(1.0, exponent - 1);
}

/// A unit to measure lengths of about `size` in, so that products of up to four are safe: 1 for most, else a power of
/// two next to `size`. To divide by it is exact.
inline double unitFor(double size) {
  if ((0x1p-200 < size && size < 0x1p200) || !(size > 0) || std::isinf(size)) return 1;
  return powerOfTwoIn(size);
}

inline double largestOf(Vector v) { return std::max(std::abs(v.x), std::abs(v.y)); }
inline Vector measuredIn(double unit, Vector v) { return unit == 1 ? v : Vector{v.x / unit, v.y / unit}; }

/// The length of a vector of any size.
inline double lengthOf(Vector v) {
  const double square = dot(v, v);
  if (isSafe(square)) return std::sqrt(square);
  const double unit = unitFor(largestOf(v));
  return unit * length(measuredIn(unit, v));
}

/// The cross product but for a factor above 0: positive if the way from u to v is a left turn.
inline double turn(Vector u, Vector v) {
  const double product = cross(u, v);
  if (isSafe(product)) return product;
  return cross(measuredIn(unitFor(largestOf(u)), u), measuredIn(unitFor(largestOf(v)), v));
}

/// The dot product but for a factor above 0.
inline double facing(Vector u, Vector v) {
  return dot(measuredIn(unitFor(largestOf(u)), u), measuredIn(unitFor(largestOf(v)), v));
}

}  // namespace circle_voronoi
