// SPDX-License-Identifier: GPL-3.0-or-later
#include "in_circle.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <initializer_list>

#include "integers.h"
#include "short_differences.h"

namespace circle_voronoi {
namespace {

namespace multiprecision = boost::multiprecision;
__extension__ using Int128 = __int128;
using Wide = multiprecision::number<
    multiprecision::cpp_int_backend<512, 512, multiprecision::signed_magnitude, multiprecision::unchecked, void>>;

// Filters by J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates", 1997,
// section 4, with u = 2^-53; kTiny covers underflow (homogeneous_disc.h has the argument).
constexpr double kUnit = 0x1p-53;
constexpr double kTiny = 0x1p-500;
constexpr double kOrientationError = (3 + 16 * kUnit) * kUnit;
constexpr double kInCircleError = (10 + 96 * kUnit) * kUnit;

template <class Integer>
int sign(const Integer& value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

template <class Integer>
struct IntegerPoint {
  Integer x, y;
};

template <class Integer>
IntegerPoint<Integer> relative(const CommonUnit& unit, Point p, const IntegerPoint<Integer>& to) {
  return {unit.in<Integer>(p.x) - to.x, unit.in<Integer>(p.y) - to.y};
}

template <class Integer>
int orientationOf(const CommonUnit& unit, Point a, Point b, Point c) {
  const IntegerPoint<Integer> o = {unit.in<Integer>(c.x), unit.in<Integer>(c.y)};
  const auto u = relative(unit, a, o);
  const auto v = relative(unit, b, o);
  return sign<Integer>(u.x * v.y - u.y * v.x);
}

template <class Integer>
int inCircleOf(const CommonUnit& unit, Point a, Point b, Point c, Point d) {
  const IntegerPoint<Integer> o = {unit.in<Integer>(d.x), unit.in<Integer>(d.y)};
  const auto u = relative(unit, a, o);
  const auto v = relative(unit, b, o);
  const auto w = relative(unit, c, o);
  return sign<Integer>((u.x * u.x + u.y * u.y) * (v.x * w.y - v.y * w.x) +
                       (v.x * v.x + v.y * v.y) * (w.x * u.y - w.y * u.x) +
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
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double determinant = left - right;
  const double error = kOrientationError * (std::abs(left) + std::abs(right)) + kTiny;
  if (determinant > error) return 1;
  if (determinant < -error) return -1;
  // On a line along an axis.
  if ((a.x == c.x || b.y == c.y) && (a.y == c.y || b.x == c.x)) return 0;
  const double largest =
      std::max(std::max(std::abs(a.x - c.x), std::abs(a.y - c.y)), std::max(std::abs(b.x - c.x), std::abs(b.y - c.y)));
  if (haveShortDifferences<26>({a, b, c}, largest)) return sign(determinant);
  const CommonUnit unit = commonUnit({a, b, c});
  // Differences have one bit more, and the sum of two products of two of them one more.
  const int bits = 2 * (unit.bits() + 1) + 1;
  if (bits < 127) return orientationOf<Int128>(unit, a, b, c);
  if (bits < 512) return orientationOf<Wide>(unit, a, b, c);
  return orientationOf<multiprecision::cpp_int>(unit, a, b, c);
}

int inCircle(Point a, Point b, Point c, Point d) {
  const double ax = a.x - d.x, ay = a.y - d.y;
  const double bx = b.x - d.x, by = b.y - d.y;
  const double cx = c.x - d.x, cy = c.y - d.y;
  const double aa = ax * ax + ay * ay;
  const double bb = bx * bx + by * by;
  const double cc = cx * cx + cy * cy;
  const double determinant = aa * (bx * cy - by * cx) + bb * (cx * ay - cy * ax) + cc * (ax * by - ay * bx);
  // Shewchuk's bound is in aa (|bx cy| + |by cx|) + ..., which is at most aa sqrt(bb cc) + ... and so at most
  // aa bb + bb cc + cc aa <= (aa + bb + cc)^2 / 3: cheaper, and hardly ever too coarse for points near one another.
  const double size = aa + bb + cc;
  const double error = kInCircleError * size * size + kTiny;
  if (determinant > error) return 1;
  if (determinant < -error) return -1;
  const double largest = std::max({std::abs(ax), std::abs(ay), std::abs(bx), std::abs(by), std::abs(cx), std::abs(cy)});
  // The determinant is at most 12 times the fourth power of one.
  if (haveShortDifferences<12>({a, b, c, d}, largest)) return sign(determinant);
  const double permanent = aa * (std::abs(bx * cy) + std::abs(by * cx)) + bb * (std::abs(cx * ay) + std::abs(cy * ax)) +
                           cc * (std::abs(ax * by) + std::abs(ay * bx));
  const double fineError = kInCircleError * permanent + kTiny;
  if (determinant > fineError) return 1;
  if (determinant < -fineError) return -1;
  const CommonUnit unit = commonUnit({a, b, c, d});
  // Differences have one bit more, and the sum of twelve products of four of them has four more.
  const int bits = 4 * (unit.bits() + 1) + 4;
  if (bits < 127) return inCircleOf<Int128>(unit, a, b, c, d);
  if (bits < 512) return inCircleOf<Wide>(unit, a, b, c, d);
  return inCircleOf<multiprecision::cpp_int>(unit, a, b, c, d);
}

}  // namespace circle_voronoi
