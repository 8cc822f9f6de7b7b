// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace circle_voronoi::cli {

// Elementary functions made only of sums, products and square roots. Unlike the C library's functions, they have the
// same bits on every machine. Their error is a few units in the last place.

inline constexpr double kPi = 3.14159265358979323846;

/// A sine and a cosine.
struct SineCosine {
  double sine = 0;
  double cosine = 1;
};

/// Arguments are angles in radians, of at most a few turns.
inline SineCosine sineCosine(double angle) {
  constexpr double kHalfTurnHigh = 1.57079632679489655800;  // half of pi in two parts
  constexpr double kHalfTurnLow = 6.123233995736766e-17;
  const double quarter = std::floor(angle / kHalfTurnHigh + 0.5);
  const double x = (angle - quarter * kHalfTurnHigh) - quarter * kHalfTurnLow;
  double sine = 0;
  double cosine = 0;
  for (int k = 8; k >= 0; --k) {  // Taylor, to x^18
    const double n = 2 * k;
    cosine = 1 - x * x / ((n + 1) * (n + 2)) * cosine;
    sine = 1 - x * x / ((n + 2) * (n + 3)) * sine;
  }
  sine *= x;
  switch (static_cast<int>(quarter - 4 * std::floor(quarter / 4))) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    default:
      return {-cosine, sine};
  }
}

/// The angle of the point (x, y), from -pi to pi.
inline double angleOf(double y, double x) {
  if (x == 0 && y == 0) return 0;
  const double across = std::abs(y);
  const double along = std::abs(x);
  const bool isSteep = across > along;
  const double ratio = isSteep ? along / across : across / along;  // up to 1
  // The tangent of a sixth of a right angle and more is turned back by a third of one.
  constexpr double kRoot3 = 1.73205080756887729353;
  const bool isTurned = ratio > 0.26794919243112270647;
  const double t = isTurned ? (kRoot3 * ratio - 1) / (kRoot3 + ratio) : ratio;
  double series = 0;
  for (int k = 15; k >= 0; --k) series = 1.0 / (2 * k + 1) - t * t * series;
  double angle = t * series + (isTurned ? kPi / 6 : 0);
  if (isSteep) angle = kPi / 2 - angle;
  if (x < 0) angle = kPi - angle;
  return y < 0 ? -angle : angle;
}

/// The inverse hyperbolic tangent of a number up to 0.2.
inline double smallArtanh(double x) {
  double series = 0;
  for (int k = 15; k >= 0; --k) series = 1.0 / (2 * k + 1) + x * x * series;
  return x * series;
}

/// The natural logarithm of a positive number.
inline double logarithm(double x) {
  constexpr double kLog2 = 0.69314718055994530942;
  int exponent = 0;
  double part = std::frexp(x, &exponent);  // exact
  if (part < 0.70710678118654752440) {
    part *= 2;
    --exponent;
  }
  return 2 * smallArtanh((part - 1) / (part + 1)) + exponent * kLog2;
}

/// e to the power of x, for x of moderate size.
inline double exponential(double x) {
  constexpr double kLog2 = 0.69314718055994530942;
  const double power = std::floor(x / kLog2 + 0.5);
  const double rest = x - power * kLog2;
  double series = 1;
  for (int k = 18; k > 0; --k) series = 1 + rest / k * series;
  return std::ldexp(series, static_cast<int>(power));  // exact
}

}  // namespace circle_voronoi::cli
