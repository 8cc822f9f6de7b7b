// SPDX-License-Identifier: GPL-3.0-or-later
//
// The disc of a face in floating point, and the quantities derived from it, each with an error bound.
//
// u is the unit roundoff. Products of (1 + u) are rounded up generously instead of being followed to the last term.
// The components of a difference are 0 or between 2^-96 and 2^97 (limits.h), and its length is below 2^98. So nothing
// overflows: the highest power of a length is 6 under a root and 10 in a cross product, where the directions of discOf
// are below 4 2^(98 * 5), so that their cross product is below 2^(5 + 98 * 10) = 2^985. kUnderflowError covers
// underflow.
#pragma once

#include <algorithm>
#include <cmath>
#include <tuple>

#include "circle_voronoi/circle.h"
#include "estimate.h"
#include "exact.h"
#include "portable.h"

namespace circle_voronoi {

/// The difference u - o of two circles in (x, y, r) space.
struct Difference {
  double x, y, s;

  Difference(const Circle& u, const Circle& o) : x(u.x - o.x), y(u.y - o.y), s(u.r - o.r) {}
  Difference(double x_, double y_, double s_) : x(x_), y(y_), s(s_) {}

  Difference operator-() const { return {-x, -y, -s}; }
};

inline double lorentzDot(const Difference& u, const Difference& v) { return u.x * v.x + u.y * v.y - u.s * v.s; }

inline Difference cross(const Difference& u, const Difference& v) {
  return {u.y * v.s - u.s * v.y, u.s * v.x - u.x * v.s, u.x * v.y - u.y * v.x};
}

inline double sizeSquared(const Difference& u) { return u.x * u.x + u.y * u.y + u.s * u.s; }

inline double size(const Difference& u) { return std::sqrt(sizeSquared(u)); }

/// The disc of a face as a homogeneous point (x, y : w), w >= 0, relative to a circle o of the face. Seen from any
/// circle c of the face, the direction to the center of the disc is (x, y) + w (o - c), each component within `error`.
/// `rho` is w times the distance between the centers of o and of the disc. It is right within `error`, also if the
/// distance from another circle of the face is derived from it.
struct HomogeneousDisc {
  double x = 0, y = 0, w = 0, rho = 0;
  double error = kUnknownError;
};

/// Returns the direction to infinity, normal to the tangent line to the left of a -> b. With d = b - a and g = <d, d>
/// it is -d.s (d.x, d.y) + sqrt(g) (-d.y, d.x). The error is unknown unless g is certainly positive.
///
/// Error: let l = |d|, each component right within u. g <= l^2 is right within 6 u l^2, so sqrt(g) <= l within
/// 6 u l^2 / sqrt(g) + u l. Each component is a sum of two products of at most l^2: 2 * 4 u l^2, and l times the error
/// of the root; together under 20 u l^3 / sqrt(g).
inline HomogeneousDisc discAtInfinity(const Circle& a, const Circle& b) {
  constexpr double u = kUnitRoundoff;
  const Difference d(b, a);
  const double g = lorentzDot(d, d);
  HomogeneousDisc disc;
  const double l = size(d);
  if (g <= 12 * u * l * l) return disc;
  const double root = std::sqrt(g);
  disc.x = -d.s * d.x - root * d.y;
  disc.y = -d.s * d.y + root * d.x;
  disc.error = 20 * u * l * l * l / root + kUnderflowError;
  return disc;
}

/// The disc of three circles in counter-clockwise order, relative to the circle with the index `corner` (0 to 2).
/// `discOf` takes the corner opposite the longest side, because both differences from it are short. If several such
/// corners exist, it takes the one with the smallest center, by x and then y. The disc therefore has the same bits
/// whichever circle is passed first.
struct CornerDisc {
  HomogeneousDisc disc;
  int corner = 0;
};

/// Returns whether the center that a difference starts from comes before the other, by x and then y.
inline bool startsBefore(const Difference& d) { return d.x > 0 || (d.x == 0 && d.y > 0); }

/// Returns the corner opposite the longest side if two or three of the given squared lengths are equal. If the longest
/// side is not unique, the centers decide (CornerDisc).
CIRCLE_VORONOI_NEVER_INLINE inline int cornerOfTie(const Difference& d01, const Difference& d12, const Difference& d20,
                                                   double size01, double size12, double size20) {
  const double longest = std::max({size01, size12, size20});
  const bool may0 = size12 == longest;
  const bool may1 = size20 == longest;
  const bool may2 = size01 == longest;
  if (may0 && (!may1 || startsBefore(d01)) && (!may2 || !startsBefore(d20))) return 0;
  return may1 && (!may0 || !startsBefore(d01)) && (!may2 || startsBefore(d12)) ? 1 : 2;
}

/// Computes the disc of three circles c0, c1, c2 from d01 = c1 - c0, d12 = c2 - c1 and d20 = c0 - c2. The error is
/// unknown if rounding hides the result.
///
/// Let A and B be the differences from the corner o, C = B - A, <.,.> the Lorentz product, ' negate the third
/// component, g11 = <A,A>, g22 = <B,B>, g33 = <C,C>, g12 = <A,B>, N = A x B, k = <N,N>, S = sqrt(g11 g22 g33). The
/// center, with its distance from that of o as the third component, solves <A',X> = g11 / 2, <B',X> = g22 / 2, <X,X> =
/// 0. There are two solutions. The counter-clockwise disc is
///   -sign(k) (g22 (g11 - g12) A' + g11 (g22 - g12) B' + N S) / w,  w = 2 |k|.
///
/// Error: let a = |A|, b = |B|, c = |C| >= a, b in (x, y, s) space, T = a b c, Q = a b T. Differences are right within
/// u relatively.
/// - g11 <= a^2, g12 <= a b, g22 <= b^2, g33 <= c^2, each within 5 u of that bound.
/// - g11 - g12 = <A, A - B> <= a c, within 5 u a (a + b) + u a c <= 11 u a c; times g22 within 17 u b^2 a c; times A'
///   within 19 u Q. The other product has the same error, so their sum is within 40 u Q.
/// - N <= a b in each component, within 4 u a b.
/// - S^2 <= T^2 within 17 u T^2, so S is within 10 u T^2 / S + u S, provided that S^2 > 40 u T^2.
/// - N S within 10 u Q T / S + 6 u Q, since S <= T. The final sum adds 3 u Q.
/// - k within 11 u a b |N|_1 + 48 u^2 a^2 b^2, with the exact N, which is within 12 u a b of the computed one.
/// Seen from another corner, w times a difference of at most max(a, b) is added: within max(a, b) (error of w + 2 u w),
/// and the sum adds u (3 Q + max(a, b) w). All together 52 u Q and 10 u Q T / S, where 60 and 12 are used.
inline CornerDisc discOfSides(const Difference& d01, const Difference& d12, const Difference& d20) {
  constexpr double u = kUnitRoundoff;
  const double size01 = sizeSquared(d01);
  const double size12 = sizeSquared(d12);
  const double size20 = sizeSquared(d20);
  CornerDisc result;
  result.corner = size12 >= size01 ? (size12 >= size20 ? 0 : 1) : (size20 >= size01 ? 1 : 2);
  if (size01 == size12 || size12 == size20 || size20 == size01) {
    result.corner = cornerOfTie(d01, d12, d20, size01, size12, size20);
  }
  const auto& [a, minusB, c, aa, bb, cc] = result.corner == 0   ? std::tie(d01, d20, d12, size01, size20, size12)
                                           : result.corner == 1 ? std::tie(d12, d01, d20, size12, size01, size20)
                                                                : std::tie(d20, d12, d01, size20, size12, size01);
  const Difference b = -minusB;

  const double g11 = lorentzDot(a, a);
  const double g22 = lorentzDot(b, b);
  const double g12 = lorentzDot(a, b);
  const double g33 = lorentzDot(c, c);
  const Difference n = cross(a, b);
  const double k = lorentzDot(n, n);

  HomogeneousDisc& disc = result.disc;
  const double la = std::sqrt(aa);
  const double lb = std::sqrt(bb);
  const double ab = la * lb;
  const double t = ab * std::sqrt(cc);
  const double kError =
      12 * u * ab * (std::abs(n.x) + std::abs(n.y) + std::abs(n.s)) + 200 * u * u * ab * ab + kUnderflowError;
  const double square = g11 * g22 * g33;
  if (std::abs(k) <= kError || square <= 40 * u * t * t) return result;

  const double s = std::sqrt(square);
  const double alpha = g22 * (g11 - g12);
  const double beta = g11 * (g22 - g12);
  const double turn = k < 0 ? 1 : -1;
  disc.x = turn * (alpha * a.x + beta * b.x + n.x * s);
  disc.y = turn * (alpha * a.y + beta * b.y + n.y * s);
  disc.rho = turn * (n.s * s - alpha * a.s - beta * b.s);
  disc.w = -2 * turn * k;
  disc.error = u * ab * t * (60 + 12 * (t / s)) + kUnderflowError + std::max(la, lb) * (2 * kError + 4 * u * disc.w);
  return result;
}

/// Computes the disc of three circles in counter-clockwise order.
inline CornerDisc discOf(const Circle& c0, const Circle& c1, const Circle& c2) {
  return discOfSides(Difference(c1, c0), Difference(c2, c1), Difference(c0, c2));
}

/// A direction seen from a circle, of any length, with each component right within `error`.
struct Direction {
  double x, y;
  double error;
};

/// Returns f x g. With the components of f within e and those of g within h, the result is right within e (|g.x| +
/// |g.y|) + h (|f.x| + |f.y|) + 2 e h and 2 u of the products.
inline Estimate crossOf(const Direction& f, const Direction& g) {
  const double fSize = std::abs(f.x) + std::abs(f.y);
  const double gSize = std::abs(g.x) + std::abs(g.y);
  const double error = f.error * gSize + g.error * fSize + 2 * f.error * g.error + 3 * kUnitRoundoff * fSize * gSize;
  return {f.x * g.y - f.y * g.x, error * (1 + 0x1p-40) + kUnderflowError};
}

/// Returns how far a direction points along (-kAxisY, kAxisX). This adds two products, whose factors have the sum 1622.
inline Estimate heightOf(const Direction& f) {
  const double error = f.error + 3 * kUnitRoundoff * (std::abs(f.x) + std::abs(f.y));
  return {exact::kAxisX * f.y - exact::kAxisY * f.x, 1640 * error};
}

/// Returns w times the distance between the centers of a disc and a circle of its face. `corner` is the circle that the
/// disc is relative to, and `circle` must not be larger.
inline Estimate distanceOf(const Circle& circle, const HomogeneousDisc& disc, const Circle& corner) {
  return {disc.rho + disc.w * (circle.r - corner.r), disc.error};
}

/// Returns the squared length of the common tangents of two circles; negative if one strictly contains the other.
inline Estimate tangentLengthSquared(const Circle& a, const Circle& b) {
  const Difference d(a, b);
  const double l = size(d);
  return {lorentzDot(d, d), 8 * kUnitRoundoff * l * l + kUnderflowError};
}

/// Returns how far circle c reaches beyond the tangent line to the left of a -> b, times |d|^2, d = b - a, with the
/// normal of discAtInfinity.
///
/// Error: let l = |d|, m = |c - a|. e.s times l^2 at most, d.s times l m at most, both within 8 u; the cross product of
/// at most l m within 4 u, and sqrt(g) <= l within 4 u l^2 / sqrt(g) + u l, their product within 4 u l^2 m (l /
/// sqrt(g)) and 8 u l^2 m. At the angles at which these are largest together they make 16 u l^2 m (l / sqrt(g)); 20 is
/// used.
inline Estimate reachBeyond(const Circle& a, const Circle& b, const Circle& c) {
  constexpr double u = kUnitRoundoff;
  const Difference d(b, a);
  const Difference e(c, a);
  const double g = lorentzDot(d, d);
  const double l = size(d);
  if (g <= 12 * u * l * l) return {};
  const double root = std::sqrt(g);
  return {e.s * (d.x * d.x + d.y * d.y) - d.s * (d.x * e.x + d.y * e.y) + (d.x * e.y - d.y * e.x) * root,
          20 * u * l * l * size(e) * (l / root) + kUnderflowError};
}

}  // namespace circle_voronoi
