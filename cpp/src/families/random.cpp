// SPDX-License-Identifier: GPL-3.0-or-later
#include "random.h"

#include <cmath>
#include <numbers>

// Sums and products only: the functions of the standard library differ from one platform to the next.

namespace circle_voronoi {
namespace {

/// The sum of x^k / k! for k = first, first + step, ..., with alternating signs if asked; |x| < 1.
double series(double x, int first, int step, bool isAlternating) {
  constexpr int kTerms = 20;
  double term = 1;
  double sum = 0;
  double sign = 1;
  for (int k = 0; k < kTerms; ++k) {
    if (k >= first && (k - first) % step == 0) {
      sum += sign * term;
      if (isAlternating) sign = -sign;
    }
    term = term * x / (k + 1);
  }
  return sum;
}

}  // namespace

double powerOfTen(double exponent) {
  const double doublings = exponent * (std::numbers::ln10 / std::numbers::ln2);
  const double whole = std::floor(doublings + 0.5);
  return std::ldexp(series((doublings - whole) * std::numbers::ln2, 0, 1, false), static_cast<int>(whole));
}

Vector directionAt(double turns) {
  const double quarters = std::floor(4 * turns + 0.5);
  const double angle = (turns - quarters / 4) * (2 * std::numbers::pi);
  const Vector v = {series(angle, 0, 2, true), series(angle, 1, 2, true)};
  switch (static_cast<long long>(quarters) & 3) {
    case 0:
      return v;
    case 1:
      return {-v.y, v.x};
    case 2:
      return {-v.x, -v.y};
    default:
      return {v.y, -v.x};
  }
}

}  // namespace circle_voronoi
