// SPDX-License-Identifier: GPL-3.0-or-later
// Lengths whose products must not overflow: circles and regions keep the range of numbers (limits.h), but vertices lie
// up to 2^876 away (three_touch_disc.h), and points that are asked for anywhere.
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

/// Whether a sum of two products has not overflown.
inline bool isSafe(double product) { return std::abs(product) < 0x1p1000; }

/// The largest power of two up to `size` > 0.
inline double powerOfTwoIn(double size) {
  int exponent = 0;
  std::frexp(size, &exponent);
  return std::ldexp(1.0, exponent - 1);
}

/// A unit to measure lengths of about `size` in, so that products of up to four are safe: 1 for most, else a power of
/// two next to `size`. To divide by it is exact.
inline double unitFor(double size) { return size >= 0x1p200 && size < kInfinite ? powerOfTwoIn(size) : 1; }

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
