// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace circle_voronoi {

// Elementary functions made only of sums, products, quotients and square roots. Unlike the C library's functions, they
// have the same bits on every machine. Their error is a few units in the last place.

inline constexpr double kPi = 3.14159265358979323846;
/// A degree in radians.
inline constexpr double kDegree = kPi / 180;

/// A sine and a cosine.
struct SineCosine {
  double sine = 0;
  double cosine = 1;
};

namespace elementary {

/// Returns every second coefficient of the Taylor series of the exponential function, the last one first: the signs of
/// sine and cosine alternate.
template <std::size_t kCount>
constexpr std::array<double, kCount> alternating(int last) {
  std::array<double, kCount> coefficients{};
  for (std::size_t k = 0; k < kCount; ++k) {
    double factorial = 1;
    for (int n = last - 2 * static_cast<int>(k); n > 1; --n) factorial *= n;
    coefficients[k] = ((kCount - 1 - k) % 2 == 0 ? 1 : -1) / factorial;
  }
  return coefficients;
}

inline constexpr auto kSine = alternating<9>(17);
inline constexpr auto kCosine = alternating<9>(16);

/// Returns the sine and the cosine of an angle in radians within an eighth of a turn, or not much more.
inline SineCosine small(double x) {
  const double square = x * x;
  double sine = 0;
  double cosine = 0;
  for (std::size_t k = 0; k < kSine.size(); ++k) {
    sine = sine * square + kSine[k];
    cosine = cosine * square + kCosine[k];
  }
  return {sine * x, cosine};
}

/// Returns the sine and the cosine of an angle plus a number of quarter turns.
inline SineCosine turned(const SineCosine& angle, double quarters) {
  const auto [sine, cosine] = angle;
  switch (static_cast<int>(quarters) & 3) {
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

/// The coefficients of the series of the arctangent divided by its argument, the last one first, without their signs.
inline constexpr std::array kArctangent = {1.0 / 15, 1.0 / 13, 1.0 / 11, 1.0 / 9, 1.0 / 7, 1.0 / 5, 1.0 / 3, 1.0};

/// The arctangents of 0, 1/8, ..., 1.
inline constexpr std::array kArctangents = {0.0,
                                            0.12435499454676143503,
                                            0.24497866312686415417,
                                            0.35877067027057222040,
                                            0.46364760900080611621,
                                            0.55859931534356243597,
                                            0.64350110879328438680,
                                            0.71882999962162450542,
                                            0.78539816339744830962};

}  // namespace elementary

/// Returns the sine and the cosine of an angle in radians, of at most a few turns.
inline SineCosine sineCosine(double angle) {
  if (std::abs(angle) <= kPi / 4) return elementary::small(angle);
  // Half of pi in three parts. Products of the first with small integers are exact.
  constexpr double kHigh = 0x1.921fb544p+0;
  constexpr double kMiddle = 0x1.0b4611a6p-34;
  constexpr double kLow = 0x1.3198a2e037073p-69;
  const double quarters = std::floor(angle / (kPi / 2) + 0.5);
  const double rest = ((angle - quarters * kHigh) - quarters * kMiddle) - quarters * kLow;
  return elementary::turned(elementary::small(rest), quarters);
}

/// Returns the sine and the cosine of an angle in degrees, of at most a few turns. Multiples of 90 degrees are exact,
/// and results near zero are as accurate as others.
inline SineCosine sineCosineOfDegrees(double degrees) {
  if (std::abs(degrees) <= 45) return elementary::small(degrees * kDegree);
  const double quarters = std::floor(degrees / 90 + 0.5);
  return elementary::turned(elementary::small((degrees - 90 * quarters) * kDegree), quarters);
}

/// Returns the angle of the point (x, y), from -pi to pi.
inline double angleOf(double y, double x) {
  if (x == 0 && y == 0) return 0;
  const double across = std::abs(y);
  const double along = std::abs(x);
  const bool isSteep = across > along;
  const double ratio = isSteep ? along / across : across / along;  // up to 1
  const auto eighths = static_cast<std::size_t>(8 * ratio + 0.5);
  const double near = static_cast<double>(eighths) / 8;
  const double t = (ratio - near) / (1 + ratio * near);
  const double square = t * t;
  double series = 0;
  for (const double coefficient : elementary::kArctangent) series = coefficient - square * series;
  double angle = elementary::kArctangents[eighths] + t * series;
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

}  // namespace circle_voronoi
