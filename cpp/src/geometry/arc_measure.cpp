// SPDX-License-Identifier: GPL-3.0-or-later
#include "arc_measure.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace circle_voronoi {
namespace {

/// sinh(d) - d for d = ln(ratio) >= 0, with square roots alone: f(2 d) = 2 f(d) + 2 sinh(d) (cosh(d) - 1) has no
/// cancellation, and leads back to small d.
double sinhExcess(double ratio) {
  if (ratio < 1.25) {
    const double z = (ratio - 1) / (ratio + 1);
    double d = 0;
    for (int k = 15; k > 0; k -= 2) d = d * z * z + 2.0 / k;
    d *= z;
    double sum = 0;
    for (const int k : {13, 11, 9, 7, 5, 3}) sum = (1 + sum) * d * d / (k * (k - 1));
    return d * sum;
  }
  const double root = std::sqrt(ratio);
  const double sine = (root - 1 / root) / 2;
  const double cosineExcess = (root - 1) * (root - 1) / (2 * root);
  return 2 * sinhExcess(root) + 2 * sine * cosineExcess;
}

/// The speed of the parameter: |d point / d s|.
double speed(const Bisector& bisector, double s) {
  const double x = bisector.a * (1 - 1 / s) * (1 + 1 / s);
  const double y = bisector.b * (1 + 1 / (s * s));
  return std::sqrt(x * x + y * y) / 2;
}

double gauss(const Bisector& bisector, double from, double to) {
  // Abscissas and weights of the Gauss-Legendre rule of order 8 (Abramowitz and Stegun, table 25.4).
  constexpr std::array<std::array<double, 2>, 4> kRule = {{{0.183434642495649805, 0.362683783378361983},
                                                           {0.525532409916328986, 0.313706645877887287},
                                                           {0.796666477413626740, 0.222381034453374471},
                                                           {0.960289856497536232, 0.101228536290376259}}};
  const double middle = (from + to) / 2;
  const double half = (to - from) / 2;
  double sum = 0;
  for (const auto& [x, weight] : kRule) {
    sum += weight * (speed(bisector, middle - half * x) + speed(bisector, middle + half * x));
  }
  return half * sum;
}

double adaptive(const Bisector& bisector, double from, double to, double whole, int depth) {
  const double middle = (from + to) / 2;
  const double first = gauss(bisector, from, middle);
  const double second = gauss(bisector, middle, to);
  if (depth == 0 || std::abs(first + second - whole) <= 1e-13 * whole) return first + second;
  return adaptive(bisector, from, middle, first, depth - 1) + adaptive(bisector, middle, to, second, depth - 1);
}

/// From parameter 1 <= from to `to`: a branch is alike on both sides of its apex.
double lengthBeyondApex(const Bisector& bisector, double from, double to) {
  constexpr int kDepth = 60;
  return to > from ? adaptive(bisector, from, to, gauss(bisector, from, to), kDepth) : 0;
}

}  // namespace

double arcLength(const EdgeCurve& curve) {
  const auto& [bisector, from, to, start, end] = curve;
  if (bisector.a == 0) return std::sqrt((end.x - start.x) * (end.x - start.x) + (end.y - start.y) * (end.y - start.y));
  if (to <= 1) return lengthBeyondApex(bisector, 1 / to, 1 / from);
  if (from >= 1) return lengthBeyondApex(bisector, from, to);
  return lengthBeyondApex(bisector, 1, 1 / from) + lengthBeyondApex(bisector, 1, to);
}

// In the frame of the middle of the hyperbola and of conjugate half-diameters along the arc's middle parameter, the
// region is sqrt(1 + y^2) <= x <= cosh h with |y| <= sinh h, h half the width of the arc in t. Its area is
// (sinh(2 h) - 2 h) / 2, and the integral of x over it 2 / 3 sinh^3 h.
Moments momentsOverChord(const EdgeCurve& curve, Point reference) {
  const auto& [bisector, from, to, start, end] = curve;
  if (bisector.a == 0 || !(to > from)) return {};
  const double a = std::abs(bisector.a);
  const double unitArea = sinhExcess(std::min(to / from, 1e300)) / 2;
  if (unitArea == 0) return {};
  const double root = std::sqrt(to) / std::sqrt(from);
  const double sine = (root - 1 / root) / 2;
  const double shift = 2.0 / 3 * (sine / unitArea * sine) * sine;

  const double middle = std::sqrt(from) * std::sqrt(to);
  const double along = bisector.apex + a - a * shift * (middle + 1 / middle) / 2;
  const double across = bisector.b * shift * (middle - 1 / middle) / 2;
  const double x = bisector.origin.x - reference.x + (along * bisector.along.x + across * bisector.across.x);
  const double y = bisector.origin.y - reference.y + (along * bisector.along.y + across * bisector.across.y);
  // The branch bends away from its smaller circle.
  const double area = -bisector.a * bisector.b * unitArea;
  return {area, area * x, area * y};
}

}  // namespace circle_voronoi
