// SPDX-License-Identifier: GPL-3.0-or-later
//
// The disc of a face in floating point with an error bound, in double or double-double arithmetic.
//
// u is the unit roundoff of the arithmetic; products of (1 + u) are rounded up generously instead of being followed to
// the last term. Validation brought the largest coordinate near 2^80, so nothing overflows: the highest power of a
// length is 6 under a root and 10 in a cross product, 2^(81 * 10) < 2^1024. Underflow can add an absolute error; kTiny
// covers it: it exceeds the sum of all underflow errors, each at most 2^-1022 times a factor below 2^(81 * 6), and is
// negligible where lengths exceed about 2^-40, that is 1e-36 of the whole. Smaller ones are decided exactly.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <tuple>

#include "circle_voronoi/circle.h"
#include "double_double.h"

namespace circle_voronoi {

inline constexpr double kTiny = 0x1p-500;
inline constexpr double kUnknownError = std::numeric_limits<double>::infinity();

template <class Real>
inline constexpr double kUnitRoundoff = 0;
template <>
inline constexpr double kUnitRoundoff<double> = 0x1p-53;
template <>
inline constexpr double kUnitRoundoff<DoubleDouble> = 0x1p-100;

inline double high(double a) { return a; }
inline double high(const DoubleDouble& a) { return a.high(); }

/// u - o in (x, y, r) space.
template <class Real>
struct Difference {
  Real x, y, s;

  Difference(const Circle& u, const Circle& o) requires std::same_as<Real, double>
      : x(u.x - o.x), y(u.y - o.y), s(u.r - o.r) {}
  Difference(const Circle& u, const Circle& o) requires std::same_as<Real, DoubleDouble>
      : x(DoubleDouble::difference(u.x, o.x)),
        y(DoubleDouble::difference(u.y, o.y)),
        s(DoubleDouble::difference(u.r, o.r)) {}
  Difference(const Real& x_, const Real& y_, const Real& s_) : x(x_), y(y_), s(s_) {}
};

template <class Real>
Real cone(const Difference<Real>& u, const Difference<Real>& v) {
  return u.x * v.x + u.y * v.y - u.s * v.s;
}

template <class Real>
Difference<Real> operator-(const Difference<Real>& u) {
  return {-u.x, -u.y, -u.s};
}

template <class Real>
double sizeSquared(const Difference<Real>& u) {
  const double x = high(u.x);
  const double y = high(u.y);
  const double s = high(u.s);
  return x * x + y * y + s * s;
}

/// The length, not below it by more than rounding even where the squares underflow.
template <class Real>
double size(const Difference<Real>& u) {
  return std::sqrt(sizeSquared(u)) + kTiny;
}

/// The homogeneous point (x, y : w), w >= 0, relative to a circle o of the face: seen from any circle c of the face,
/// the direction to the centre of the disc is (x, y) + w (o - c), each component within `error`. `rho` is w times the
/// distance from o, within `error` too when the distance from another circle of the face is derived from it.
template <class Real>
struct HomogeneousDisc {
  Real x{}, y{}, w{}, rho{};
  double error = kUnknownError;
};

/// The direction to infinity, normal to the tangent line to the left of a -> b: with d = b - a and g = <d, d> it is
/// -d.s (d.x, d.y) + sqrt(g) (-d.y, d.x).
///
/// Error: let l = |d|, each component right within u. g <= l^2 is right within 6 u l^2, so sqrt(g) <= l within
/// 6 u l^2 / sqrt(g) + u l. Each component is a sum of two products of at most l^2: 2 * 4 u l^2, and l times the error
/// of the root; together under 20 u l^3 / sqrt(g).
template <class Real>
HomogeneousDisc<Real> discAtInfinity(const Circle& a, const Circle& b) {
  using std::sqrt;
  constexpr double u = kUnitRoundoff<Real>;
  const Difference<Real> d(b, a);
  const Real g = cone(d, d);
  HomogeneousDisc<Real> disc;
  const double l = size(d);
  if (high(g) <= 12 * u * l * l) return disc;
  const Real root = sqrt(g);
  disc.x = -d.s * d.x - root * d.y;
  disc.y = -d.s * d.y + root * d.x;
  disc.error = 20 * u * l * l * l / high(root) + kTiny;
  return disc;
}

/// The disc of three circles counter-clockwise, relative to one of them: the `corner` opposite the longest side, from
/// which both differences are short.
template <class Real>
struct CornerDisc {
  HomogeneousDisc<Real> disc;
  int corner = 0;
};

/// By the formula of exact.cpp, with A and B the differences from the corner o, C = B - A:
///   -sign(k) (g22 (g11 - g12) A' + g11 (g22 - g12) B' + N S),  w = 2 |k|,  k = <N,N>,  S = sqrt(g11 g22 g33).
///
/// Error: let a = |A|, b = |B| in (x, y, s) space; differences are right within u relatively.
/// - g11 <= a^2, g12 <= a b, g22 <= b^2, g33 <= (a + b)^2, each within 6 u of that bound.
/// - M = g22 (g11 - g12) A' + ...: each of the two products is at most Q = a^2 b^2 (a + b), within 17 u Q; M within 36
/// u Q.
/// - N <= a b in each component, within 5 u a b.
/// - S^2 <= T^2 with T = a b (a + b), within 20 u T^2, so S is within 20 u T^2 / S + u S, provided that S^2 > 40 u T^2.
/// - N S within 20 u Q T / S + 7 u Q, since a b T = Q. The final sum adds 3 u Q.
///   As T >= S, each component, and rho, is within 67 u Q T / S; 80 is used.
/// - k within 2 |N| sqrt(3) 5 u a b + 4 u |N|^2 + 75 u^2 a^2 b^2 < 24 u a b |N|_1 + 80 u^2 a^2 b^2.
/// Seen from another corner, w times a difference of at most max(a, b) is added: within max(a, b) (error of w + 4 u w),
/// and 2 u of the sum, which is below the Q T / S terms counted (80 against 67) and 2 u max(a, b) w.
template <class Real>
CornerDisc<Real> discOf(const Circle& c0, const Circle& c1, const Circle& c2) {
  using std::sqrt;
  constexpr double u = kUnitRoundoff<Real>;
  const Difference<Real> d01(c1, c0);
  const Difference<Real> d12(c2, c1);
  const Difference<Real> d20(c0, c2);
  const double size01 = sizeSquared(d01);
  const double size12 = sizeSquared(d12);
  const double size20 = sizeSquared(d20);
  CornerDisc<Real> result;
  result.corner = size12 >= size01 ? (size12 >= size20 ? 0 : 1) : (size20 >= size01 ? 1 : 2);
  const auto& [a, minusB, c, aa, bb] = result.corner == 0   ? std::tie(d01, d20, d12, size01, size20)
                                       : result.corner == 1 ? std::tie(d12, d01, d20, size12, size01)
                                                            : std::tie(d20, d12, d01, size20, size12);
  const Difference<Real> b = -minusB;

  const Real g11 = cone(a, a);
  const Real g22 = cone(b, b);
  const Real g12 = cone(a, b);
  const Real g33 = cone(c, c);
  const Difference<Real> n(a.y * b.s - a.s * b.y, a.s * b.x - a.x * b.s, a.x * b.y - a.y * b.x);
  const Real k = cone(n, n);

  HomogeneousDisc<Real>& disc = result.disc;
  const double la = std::sqrt(aa);
  const double lb = std::sqrt(bb);
  const double ab = la * lb;
  const double t = ab * (la + lb);
  const double kError =
      24 * u * ab * (std::abs(high(n.x)) + std::abs(high(n.y)) + std::abs(high(n.s))) + 80 * u * u * ab * ab + kTiny;
  const Real square = g11 * g22 * g33;
  if (std::abs(high(k)) <= kError || high(square) <= 40 * u * t * t) return result;

  const Real s = sqrt(square);
  const Real alpha = g22 * (g11 - g12);
  const Real beta = g11 * (g22 - g12);
  const double turn = high(k) < 0 ? 1 : -1;
  disc.x = turn * (alpha * a.x + beta * b.x + n.x * s);
  disc.y = turn * (alpha * a.y + beta * b.y + n.y * s);
  disc.rho = turn * (n.s * s - alpha * a.s - beta * b.s);
  disc.w = -2 * turn * k;
  disc.error = 80 * u * ab * t * (t / high(s)) + kTiny + std::max(la, lb) * (2 * kError + 6 * u * high(disc.w));
  return result;
}

/// A direction seen from a circle, each component within `error`.
template <class Real>
struct Direction {
  Real x, y;
  double error;
};

/// From circle `from` of a face to its disc, given relative to circle o of the face.
template <class Real>
Direction<Real> seenFrom(const Circle& from, const HomogeneousDisc<Real>& disc, const Circle& o) {
  const Difference<Real> shift(o, from);
  return {disc.x + disc.w * shift.x, disc.y + disc.w * shift.y, disc.error};
}

/// The sign of f x g, 0 if the error bound does not decide: with the components of f within e and those of g within h
/// it is right within e (|g.x| + |g.y|) + h (|f.x| + |f.y|) + 2 e h and 3 u of the products.
template <class Real>
int filteredCross(const Direction<Real>& f, const Direction<Real>& g) {
  const double fSize = std::abs(high(f.x)) + std::abs(high(f.y));
  const double gSize = std::abs(high(g.x)) + std::abs(high(g.y));
  const double error =
      (f.error * gSize + g.error * fSize + 2 * f.error * g.error + 3 * kUnitRoundoff<Real> * fSize * gSize) *
          (1 + 0x1p-40) +
      kTiny;
  const double value = high(f.x * g.y - f.y * g.x);
  return value > error ? 1 : value < -error ? -1 : 0;
}

}  // namespace circle_voronoi
