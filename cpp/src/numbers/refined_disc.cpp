// SPDX-License-Identifier: GPL-3.0-or-later
#include "refined_disc.h"

#include <algorithm>
#include <cmath>

namespace circle_voronoi {
namespace {

constexpr double u = kUnitRoundoff;
/// Where no squared tangent length is a smaller part of the squares that it comes from, discOf loses little.
constexpr double kMuch = 1.0 / 64;

/// The exact result of an operation: the rounded one and what it lacks.
struct TwoPart {
  double value, rest;
};

/// D. E. Knuth, "The Art of Computer Programming", volume 2, section 4.2.2.
TwoPart sum(double a, double b) {
  const double value = a + b;
  const double part = value - a;
  return {value, (a - (value - part)) + (b - part)};
}

/// T. J. Dekker, "A floating-point technique for extending the available precision", 1971.
TwoPart square(double a) {
  const double value = a * a;
  const double c = 0x1.0000002p27 * a;
  const double high = c - (c - a);
  const double low = a - high;
  return {value, ((high * high - value) + 2 * high * low) + low * low};
}

/// The squared length of the common tangents of two circles, and a bound on its relative error.
struct TangentSquare {
  double value, error;
};

/// Error: let l be the length of the difference in (x, y, s) space. The squares of the rounded differences and their
/// two sums are exact in two parts; what remains, twice the differences' products with their rests and the rests of the
/// squares and the sums, is at most 2 u l^2 + u l^2 + 2 u l^2, within 8 u of that; the squares of the rests are at most
/// u^2 l^2. So all is within 41 u^2 l^2, and the last sum within u of the value.
TangentSquare tangentSquare(const Circle& p, const Circle& o) {
  const TwoPart x = sum(p.x, -o.x);
  const TwoPart y = sum(p.y, -o.y);
  const TwoPart s = sum(p.r, -o.r);
  const TwoPart xx = square(x.value);
  const TwoPart yy = square(y.value);
  const TwoPart ss = square(s.value);
  const TwoPart plane = sum(xx.value, yy.value);
  const TwoPart all = sum(plane.value, -ss.value);
  const double products = x.value * x.rest + y.value * y.rest - s.value * s.rest;
  const double value = all.value + ((2 * products + (xx.rest + yy.rest - ss.rest)) + (plane.rest + all.rest));
  const double lost = 41 * u * u * (plane.value + ss.value) + kUnderflowError;
  return {value, u + lost / value};
}

}  // namespace

// The formula of discOf with g12 = (g11 + g22 - g33) / 2 and k = g12^2 - g11 g22.
//
// Error: let e be the largest relative error of g11, g22, g33 and P their sum, `whole`.
// - m = g11 - g12 and g22 - g12 are half of what remains of P where one of the three is subtracted: at most P / 2,
//   within (e + 2 u) P / 2. So is g12.
// - alpha and beta are at most g22 P / 2 and g11 P / 2, within 2 e + 4 u of these; times A and B within 2 e + 6 u.
// - N is at most a b in each component, within 4 u a b. S is within 1.5 e + 2.5 u of itself, N S within 1.5 e + 8 u of
//   a b S.
// - k within g12^2 + g11 g22 times 2 e + 4 u, and |g12| (e + 2 u) P for the error of g12; its square is in the last
// bit. The final sum adds 3 u, as do sight from another corner and the sum with it.
CornerDisc refinedDiscOf(const Circle& c0, const Circle& c1, const Circle& c2) {
  CornerDisc result = {{}, 0};
  const double size01 = sizeSquared({c1, c0});
  const double size12 = sizeSquared({c2, c1});
  const double size20 = sizeSquared({c0, c2});
  result.corner = size12 >= size01 ? (size12 >= size20 ? 0 : 1) : (size20 >= size01 ? 1 : 2);
  const auto isLost = [](const Circle& c, const Circle& d, double square) {
    const Difference difference(c, d);
    return cone(difference, difference) < kMuch * square;
  };
  if (!isLost(c1, c0, size01) && !isLost(c2, c1, size12) && !isLost(c0, c2, size20)) return discOf(c0, c1, c2);
  const Circle& o = result.corner == 0 ? c0 : result.corner == 1 ? c1 : c2;
  const Circle& p = result.corner == 0 ? c1 : result.corner == 1 ? c2 : c0;
  const Circle& q = result.corner == 0 ? c2 : result.corner == 1 ? c0 : c1;
  const TangentSquare g11 = tangentSquare(p, o);
  const TangentSquare g22 = tangentSquare(q, o);
  const TangentSquare g33 = tangentSquare(q, p);
  if (g11.value <= 0 || g22.value <= 0 || g33.value <= 0) return result;
  const double e = std::max({g11.error, g22.error, g33.error});
  if (e > 0x1p-20) return result;

  const Difference a(p, o);
  const Difference b(q, o);
  const Difference n(a.y * b.s - a.s * b.y, a.s * b.x - a.x * b.s, a.x * b.y - a.y * b.x);
  const double s = std::sqrt(g11.value * g22.value * g33.value);
  const double whole = g11.value + g22.value + g33.value;
  const double g12 = (g11.value + g22.value - g33.value) / 2;
  const double alpha = g22.value * ((g11.value + g33.value - g22.value) / 2);
  const double beta = g11.value * ((g22.value + g33.value - g11.value) / 2);
  const double k = g12 * g12 - g11.value * g22.value;
  const double kError = (g12 * g12 + g11.value * g22.value) * (2 * e + 4 * u) +
                        (std::abs(g12) + e * whole) * (e + 2 * u) * whole + kUnderflowError;
  if (std::abs(k) <= kError) return result;

  const double la = size(a);
  const double lb = size(b);
  HomogeneousDisc& disc = result.disc;
  const double turn = k < 0 ? 1 : -1;
  disc.x = turn * (alpha * a.x + beta * b.x + n.x * s);
  disc.y = turn * (alpha * a.y + beta * b.y + n.y * s);
  disc.rho = turn * (n.s * s - alpha * a.s - beta * b.s);
  disc.w = -2 * turn * k;
  disc.error = (2 * e + 12 * u) * ((la * g22.value + lb * g11.value) * whole / 2 + la * lb * s) +
               std::max(la, lb) * (2 * kError + 4 * u * disc.w) + kUnderflowError;
  return result;
}

}  // namespace circle_voronoi
