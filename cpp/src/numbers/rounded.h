// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/limits.h"
#include "circle_voronoi/point.h"

namespace circle_voronoi {

/// Returns a number rounded to a multiple of kCoordinateStep, ties to even. The sign stays, also that of zero.
inline double rounded(double x) {
  constexpr double kWhole = 0x1p52;  // doubles from here on are integers
  if (std::abs(x) >= kWhole * kCoordinateStep) return x;
  return std::copysign(((std::abs(x) / kCoordinateStep + kWhole) - kWhole) * kCoordinateStep, x);
}
inline Circle rounded(const Circle& c) { return {rounded(c.x), rounded(c.y), rounded(c.r)}; }
/// Returns a circle whose third number is an area, rounded to a multiple of the square of the step.
inline Circle roundedWithArea(const Circle& c) {
  return {rounded(c.x), rounded(c.y), rounded(c.r / kCoordinateStep) * kCoordinateStep};
}
inline Point rounded(Point p) { return {rounded(p.x), rounded(p.y)}; }

/// Returns the largest number of a circle, in absolute value.
inline double largestNumber(const Circle& c) { return std::max({std::abs(c.x), std::abs(c.y), std::abs(c.r)}); }

}  // namespace circle_voronoi
