// SPDX-License-Identifier: GPL-3.0-or-later
#include "in_circle.h"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <initializer_list>

#include "common_unit.h"
#include "integer.h"
#include "short_differences.h"
#include "short_lengths.h"

namespace circle_voronoi {
namespace {

__extension__ using Int128 = __int128;

template <class Number>
int signOf(const Number& value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}
template <int kDegree>
int signOf(const Integer<kDegree>& value) {
  return value.sign();
}

template <class Number>
Number numberOf(const CommonUnit& unit, double value) {
  const OddPart part = unit.in(value);
  if constexpr (std::same_as<Number, Int128>) {
    return part.odd * (Int128{1} << part.exponent);
  } else {
    return Number(part.odd, part.exponent);
  }
}

template <class Number>
struct IntegerPoint {
  Number x, y;
};

template <class Number>
IntegerPoint<Number> relative(const CommonUnit& unit, Point p, Point to) {
  const auto difference = [&](double a, double b) -> Number {
    return numberOf<Number>(unit, a) - numberOf<Number>(unit, b);
  };
  return {difference(p.x, to.x), difference(p.y, to.y)};
}

template <class Number>
int exactOrientation(const CommonUnit& unit, Point a, Point b, Point c) {
  const auto u = relative<Number>(unit, a, c);
  const auto v = relative<Number>(unit, b, c);
  return signOf(u.x * v.y - u.y * v.x);
}

template <class Number>
int exactInCircle(const CommonUnit& unit, Point a, Point b, Point c, Point d) {
  const auto u = relative<Number>(unit, a, d);
  const auto v = relative<Number>(unit, b, d);
  const auto w = relative<Number>(unit, c, d);
  return signOf((u.x * u.x + u.y * u.y) * (v.x * w.y - v.y * w.x) + (v.x * v.x + v.y * v.y) * (w.x * u.y - w.y * u.x) +
                (w.x * w.x + w.y * w.y) * (u.x * v.y - u.y * v.x));
}

CommonUnit commonUnit(std::initializer_list<Point> points) {
  CommonUnit unit;
  for (const Point& p : points) {
    unit.include(p.x);
    unit.include(p.y);
  }
  return unit;
}

}  // namespace

int orientation(Point a, Point b, Point c) {
  Estimate estimate = orientationOf(a, b, c);
  if (const int sign = estimate.sign(); sign != 0) return sign;
  // On a line along an axis.
  if ((a.x == c.x || b.y == c.y) && (a.y == c.y || b.x == c.x)) return 0;
  const double largest =
      std::max(std::max(std::abs(a.x - c.x), std::abs(a.y - c.y)), std::max(std::abs(b.x - c.x), std::abs(b.y - c.y)));
  if (largest < kShortLength) {
    estimate = orientationOf(a, b, c, scaleOf(largest));
    if (const int sign = estimate.sign(); sign != 0) return sign;
  }
  if (haveShortDifferences<26>({a, b, c}, largest)) return signOf(estimate.value);
  const CommonUnit unit = commonUnit({a, b, c});
  // Differences have one bit more, and the sum of two products of two of them one more.
  const int bits = 2 * (unit.bits() + 1) + 1;
  return bits < 127 ? exactOrientation<Int128>(unit, a, b, c) : exactOrientation<Integer<1>>(unit, a, b, c);
}

int inCircle(Point a, Point b, Point c, Point d) {
  const double largest = std::max({std::abs(a.x - d.x), std::abs(a.y - d.y), std::abs(b.x - d.x), std::abs(b.y - d.y),
                                   std::abs(c.x - d.x), std::abs(c.y - d.y)});
  const InCircleEstimate estimate(a, b, c, d, largest < kShortLength ? scaleOf(largest) : 1);
  if (const int sign = estimate.coarse().sign(); sign != 0) return sign;
  // The determinant is at most 12 times the fourth power of one.
  if (haveShortDifferences<12>({a, b, c, d}, largest)) return signOf(estimate.coarse().value);
  if (const int sign = estimate.fine().sign(); sign != 0) return sign;
  const CommonUnit unit = commonUnit({a, b, c, d});
  // Differences have one bit more, and the sum of twelve products of four of them has four more.
  const int bits = 4 * (unit.bits() + 1) + 4;
  return bits < 127 ? exactInCircle<Int128>(unit, a, b, c, d) : exactInCircle<Integer<1>>(unit, a, b, c, d);
}

}  // namespace circle_voronoi
