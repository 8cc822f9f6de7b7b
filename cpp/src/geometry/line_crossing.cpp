// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_crossing.h"

#include <cmath>
#include <utility>

#include "scale.h"

namespace circle_voronoi {

// With n the normal to the right of the line, n . (point(s) - p) > 0 becomes, multiplied by 2 s,
// (A + B) s^2 - 2 (A + k) s + (A - B) > 0, where A = -|a| n . along, B = b n . across, k = n . (p - origin - apex
// along). Only the ratios of A, B and k count.
LineCrossing::LineCrossing(const Bisector& bisector, Point p, Vector direction) {
  const Vector normal = {direction.y, -direction.x};
  const double a = -std::abs(bisector.a) * dot(normal, bisector.along);
  const double b = bisector.b * dot(normal, bisector.across);
  const double k = dot(normal, vectorTo(bisector.origin, p)) - bisector.apex * dot(normal, bisector.along);
  const double half = a + k;
  const double discriminant = k * (k + 2 * a) + b * b;
  if (!(discriminant > 0)) return;
  const double sum = half + std::copysign(std::sqrt(discriminant), half);
  // The root of larger magnitude, and the other one.
  for (const double s : {sum / (a + b), (a - b) / sum}) {
    if (s > 0 && s < kInfinite) parameters_[count_++] = s;
  }
  if (count_ == 2 && parameters_[0] > parameters_[1]) std::swap(parameters_[0], parameters_[1]);
}

}  // namespace circle_voronoi
