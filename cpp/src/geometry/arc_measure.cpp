// SPDX-License-Identifier: GPL-3.0-or-later
#include "arc_measure.h"

#include <algorithm>
#include <cmath>

#include "carlson.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

/// sinhExcess divided by the ratio, which may be beyond all numbers.
double sinhExcessShare(double ratio) { return ratio < 1e300 ? sinhExcess(ratio) / ratio : 0.5; }

/// The length from parameter 1 <= from to `to`; a branch is alike on both sides of its apex.
///
/// With Y = sinh t as the variable and m = 1 + (a / b)^2 it is b times the integral of sqrt((1 + m Y^2) / (1 + Y^2)),
/// or with y = Y^2 half of that of (1 + m y) / sqrt(y (1 + y) (1 + m y)): between any limits
///
///     R_F(U12^2, U13^2, U14^2) + m (R_D(U12^2, U13^2, U14^2) / 3 + Y_from Y_to / U14)
///
/// with the U of DLMF 19.29.5, a sum of positive terms. All sines and cosines are divided by e^t, and the U by e^t of
/// `from`: nothing overflows.
double lengthBeyondApex(const Bisector& bisector, double from, double to) {
  if (!(to > from)) return 0;
  const double ratio = bisector.a / bisector.b;
  const double m = 1 + ratio * ratio;
  struct End {
    explicit End(double s, double m)
        : sine((s - 1) / s * (1 + 1 / s) / 2),
          cosine((1 + 1 / s / s) / 2),
          speed(std::sqrt(1 / s / s + m * sine * sine)) {}
    double sine;
    double cosine;
    double speed;
  };
  const End p(from, m);
  const End q(to, m);
  const double share = from / to;
  // (Y_to^2 - Y_from^2) / to^2
  const double step =
      (to - from) / to * (1 + share) * ((from - 1) / from + (to - 1) / to / from) * (1 + 1 / from / to) / 4;
  const double u12 = (q.sine * q.cosine * p.speed + share * p.sine * p.cosine * q.speed) / step;
  const double u13 = (q.sine * q.speed * p.cosine + share * p.sine * p.speed * q.cosine) / step;
  const double u14 = (share * q.sine * p.cosine * p.speed + p.sine * q.cosine * q.speed) / step;
  const auto [first, second] = carlson(u12, u13, u14);
  return bisector.b * (first / from + m * (second / 3 / from / from / from + p.sine * q.sine / u14 * to));
}

}  // namespace

// f(2 d) = 2 f(d) + 2 sinh(d) (cosh(d) - 1) has no cancellation, and leads back to small d.
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

double arcLength(const EdgeCurve& curve) {
  const auto& [bisector, from, to, start, end] = curve;
  const double chord = lengthOf({end.x - start.x, end.y - start.y});
  if (bisector.a == 0 || !(to > from)) return chord;
  const double length = to <= 1     ? lengthBeyondApex(bisector, 1 / to, 1 / from)
                        : from >= 1 ? lengthBeyondApex(bisector, from, to)
                                    : lengthBeyondApex(bisector, 1, 1 / from) + lengthBeyondApex(bisector, 1, to);
  // The chord from point(from) to point(to), which are the ends but for rounding.
  const double middle = std::sqrt(from) * std::sqrt(to);
  const double span = (to - from) / middle;
  const double straight =
      span * lengthOf({bisector.a * (middle - 1 / middle) / 2, bisector.b * (middle + 1 / middle) / 2});
  return chord + std::max(length - straight, 0.0);
}

// In the frame of the middle of the hyperbola and of conjugate half-diameters along the arc's middle parameter, the
// region is sqrt(1 + y^2) <= x <= cosh h with |y| <= sinh h, h half the width of the arc in t. Its area is
// (sinh(2 h) - 2 h) / 2, and the integral of x over it 2 / 3 sinh^3 h. Both are divided by e^(2 h), as it may be beyond
// all numbers.
Moments momentsOverChord(const EdgeCurve& curve, Point reference, double unit) {
  const auto& [bisector, from, to, start, end] = curve;
  if (bisector.a == 0 || !(to > from)) return {};
  const double root = std::sqrt(to) / std::sqrt(from);
  const double share = sinhExcessShare(to / from) / 2;
  if (share == 0) return {};
  const double sine = (to - from) / to / 2;
  const double shift = 2.0 / 3 * (sine / share * sine) * sine * root;

  const double scale = 1 / unit;
  const double a = std::abs(bisector.a) * scale;
  const double middle = std::sqrt(from) * std::sqrt(to);
  const double along = bisector.apex * scale + a - a * shift * (middle + 1 / middle) / 2;
  const double across = bisector.b * scale * shift * (middle - 1 / middle) / 2;
  const Vector toOrigin = measuredIn(unit, {bisector.origin.x - reference.x, bisector.origin.y - reference.y});
  const double x = toOrigin.x + (along * bisector.along.x + across * bisector.across.x);
  const double y = toOrigin.y + (along * bisector.along.y + across * bisector.across.y);
  // The branch bends away from its smaller circle.
  const double area = -std::copysign(a, bisector.a) * root * (bisector.b * scale * root) * share;
  return {area, area * x, area * y};
}

}  // namespace circle_voronoi
