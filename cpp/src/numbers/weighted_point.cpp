// SPDX-License-Identifier: GPL-3.0-or-later
#include "weighted_point.h"

#include <cmath>

#include "estimate.h"
#include "weighted_numbers.h"

namespace circle_voronoi {
namespace {

/// The error of a determinant of up to three rows as a share of its permanent: less than thirty roundings follow one
/// another.
constexpr double kPowerTestError = 32 * kUnitRoundoff;

/// A weighted point as seen from another one: its place, and its height above the paraboloid's tangent plane there.
struct Lifted {
  double x, y;
  double height;
  double size;  ///< of the terms of `height`

  Lifted(const WeightedPoint& a, const WeightedPoint& from) : x(a.p.x - from.p.x), y(a.p.y - from.p.y) {
    const double square = x * x + y * y;
    height = square + ((from.weight.value - a.weight.value) + (from.weight.rest - a.weight.rest));
    size = square + std::abs(from.weight.value) + std::abs(a.weight.value);
  }
};

}  // namespace

int powerTest(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c, const WeightedPoint& d) {
  const Lifted u(a, d);
  const Lifted v(b, d);
  const Lifted w(c, d);
  const double value =
      u.height * (v.x * w.y - v.y * w.x) + v.height * (w.x * u.y - w.y * u.x) + w.height * (u.x * v.y - u.y * v.x);
  const double permanent = u.size * (std::abs(v.x * w.y) + std::abs(v.y * w.x)) +
                           v.size * (std::abs(w.x * u.y) + std::abs(w.y * u.x)) +
                           w.size * (std::abs(u.x * v.y) + std::abs(u.y * v.x));
  if (const int sign = Estimate{value, kPowerTestError * permanent + kUnderflowError}.sign(); sign != 0) return sign;
  const WeightedNumbers numbers({a.p, b.p, c.p, d.p}, {a.weight, b.weight, c.weight, d.weight});
  const auto ownWeight = numbers.weight(d.weight);
  const auto seen = [&](const WeightedPoint& point) { return numbers.between(d.p, point.p); };
  const auto heightOf = [&](const WeightedNumbers::Difference& place, const WeightedPoint& point) {
    return dotOf(place, place) + ownWeight - numbers.weight(point.weight);
  };
  const auto fromA = seen(a);
  const auto fromB = seen(b);
  const auto fromC = seen(c);
  return (heightOf(fromA, a) * crossOf(fromB, fromC) + heightOf(fromB, b) * crossOf(fromC, fromA) +
          heightOf(fromC, c) * crossOf(fromA, fromB))
      .sign();
}

int powerTest(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c) {
  const WeightedNumbers numbers({a.p, b.p, c.p}, {a.weight, b.weight, c.weight});
  const auto fromA = numbers.between(c.p, a.p);
  const auto fromB = numbers.between(c.p, b.p);
  const auto ownWeight = numbers.weight(c.weight);
  const auto heightOfA = dotOf(fromA, fromA) + ownWeight - numbers.weight(a.weight);
  const auto heightOfB = dotOf(fromB, fromB) + ownWeight - numbers.weight(b.weight);
  const bool isVertical = a.p.x == b.p.x;
  const auto& alongA = isVertical ? fromA.y : fromA.x;
  const auto& alongB = isVertical ? fromB.y : fromB.x;
  return (alongB * heightOfA - alongA * heightOfB).sign() * (alongB - alongA).sign();
}

}  // namespace circle_voronoi
