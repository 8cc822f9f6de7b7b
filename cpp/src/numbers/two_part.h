// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/circle.h"
#include "estimate.h"

namespace circle_voronoi {

/// A number with twice the digits of a double: the sum of a double and the rest that it lacks.
struct TwoPart {
  double value = 0;
  double rest = 0;
};

/// Returns a + b exactly. D. E. Knuth, "The Art of Computer Programming", volume 2, section 4.2.2.
inline TwoPart sum(double a, double b) {
  const double value = a + b;
  const double part = value - a;
  return {value, (a - (value - part)) + (b - part)};
}

/// Returns the upper half of the digits of a number.
inline double upperHalf(double a) {
  const double c = 0x1.0000002p27 * a;
  return c - (c - a);
}

/// Returns a b exactly, except for underflow. T. J. Dekker, "A floating-point technique for extending the available
/// precision", 1971.
inline TwoPart product(double a, double b) {
  const double value = a * b;
  const double aHigh = upperHalf(a);
  const double bHigh = upperHalf(b);
  const double aLow = a - aHigh;
  const double bLow = b - bHigh;
  return {value, ((aHigh * bHigh - value) + aHigh * bLow + aLow * bHigh) + aLow * bLow};
}

/// Returns a^2 exactly, except for underflow.
inline TwoPart square(double a) {
  const double value = a * a;
  const double high = upperHalf(a);
  const double low = a - high;
  return {value, ((high * high - value) + 2 * high * low) + low * low};
}

/// Returns a b, for factors whose rests are within u of their values.
///
/// Error: the product of the rests is at most u^2 a b and is left out. The products of a rest and a value are at most
/// u a b each, and so is the rest of the product of the values. The roundings of these three and of their sums, the
/// last of at most 3 u a b, are within 7 u^2 a b. Together this makes 8 u^2 a b. The second order is below another u^2
/// a b.
inline TwoPart product(const TwoPart& a, const TwoPart& b) {
  const TwoPart p = product(a.value, b.value);
  return sum(p.value, p.rest + (a.value * b.rest + a.rest * b.value));
}

/// The squared length of the common tangents of two circles. `error` bounds the error of both parts together.
struct TangentSquare {
  TwoPart square;
  double error = 0;
};

/// Computes the squared length of the common tangents of circles p and o.
///
/// Error: let l be the length of the difference in (x, y, s) space. The squares of the rounded differences and their
/// two sums are exact in two parts; what remains, twice the differences' products with their rests and the rests of the
/// squares and the sums, is at most 2 u l^2 + u l^2 + 2 u l^2, within 8 u of that; the squares of the rests are at most
/// u^2 l^2. Together this is within 41 u^2 l^2.
inline TangentSquare tangentSquare(const Circle& p, const Circle& o) {
  constexpr double u = kUnitRoundoff;
  const TwoPart x = sum(p.x, -o.x);
  const TwoPart y = sum(p.y, -o.y);
  const TwoPart s = sum(p.r, -o.r);
  const TwoPart xx = square(x.value);
  const TwoPart yy = square(y.value);
  const TwoPart ss = square(s.value);
  const TwoPart plane = sum(xx.value, yy.value);
  const TwoPart all = sum(plane.value, -ss.value);
  const double products = x.value * x.rest + y.value * y.rest - s.value * s.rest;
  const double rest = (2 * products + (xx.rest + yy.rest - ss.rest)) + (plane.rest + all.rest);
  return {sum(all.value, rest), 41 * u * u * (plane.value + ss.value) + kUnderflowError};
}

}  // namespace circle_voronoi
