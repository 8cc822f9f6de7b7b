// SPDX-License-Identifier: GPL-3.0-or-later
#include "spring.h"

#include <cmath>

#include "arc_measure.h"
#include "carlson.h"
#include "vectors.h"

namespace circle_voronoi {
namespace {

/// Returns ln(ratio) for ratio >= 1. Uses Carlson's R_C, because the logarithm of the C library has other bits on other
/// platforms.
double logarithm(double ratio) {
  if (!(ratio > 1)) return 0;
  if (ratio > 0x1p400) return 2 * logarithm(std::sqrt(ratio));
  const double root = std::sqrt(ratio);
  return (ratio - 1) * carlson((1 + ratio) / 2, root, root).first;
}

}  // namespace

// With the distances r and q of a point (|a| cosh t, b sinh t) from the foci, |u_left - u_right| = 2 b / sqrt(r q) and
// ds = sqrt(r q) dt, where r q = c^2 cosh^2 t - a^2 = b^2 + c^2 sinh^2 t. Hence we integrate r q / (2 b) over t. With d
// the width of the arc in t, the integral is
//
//     (b^2 d + c^2 ((sinh d - d) + sinh d (cosh(t_0 + t_1) - 1)) / 2) / (2 b),
//
// a sum of terms that are not negative.
double stiffness(const EdgeCurve& arc) {
  const auto& [bisector, from, to, start, end] = arc;
  if (!(to > from)) return 0;
  const double ratio = to / from;
  const double sine = (ratio - 1) * (1 + 1 / ratio) / 2;
  const double product = from * to;
  const double rise = (product - 1) / product * (product - 1) / 2;
  const double c2 = bisector.a * bisector.a + bisector.b * bisector.b;
  const double curved = c2 / bisector.b * (sinhExcess(ratio) + sine * rise) / 4;
  return bisector.b * logarithm(ratio) / 2 + curved;
}

double stiffnessOfPowers(const EdgeCurve& border, double distance) {
  return length({border.end.x - border.start.x, border.end.y - border.start.y}) / (2 * distance);
}

}  // namespace circle_voronoi
