// SPDX-License-Identifier: GPL-3.0-or-later
//
// Error bounds. u = 2^-53 is the unit roundoff; products of (1 + u) are rounded up generously instead of being
// followed to the last term. Validation brought the largest coordinate near 2^80, so nothing overflows: the highest
// power of a length below is 6 under a root and 10 in a cross product, 2^(81 * 10) < 2^1024. Underflow can add an
// absolute error; kTiny covers it: it exceeds the sum of all underflow errors, each at most 2^-1074 times a factor that
// stays below 2^(81 * 6), and is negligible as long as lengths exceed about 2^-40, that is 1e-36 of the whole. Smaller
// ones are decided exactly.
#include "predicates.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact.h"
#include "in_circle.h"

namespace circle_voronoi {
namespace {

constexpr double kUnit = 0x1p-53;
constexpr double kTiny = 0x1p-500;
constexpr double kUnknown = std::numeric_limits<double>::infinity();
constexpr Vector kAxis = {exact::kAxisX, exact::kAxisY};

/// The sign of a value that is known within `error`; 0 if that does not decide.
int signWithin(double value, double error) { return value > error ? 1 : value < -error ? -1 : 0; }

exact::Face exactFace(std::span<const Circle> circles, const Predicates::Triple& face) {
  const auto at = [&](int i) { return i == kInfinity ? nullptr : &circles[i]; };
  return {at(face[0]), at(face[1]), at(face[2])};
}

/// The face with infinity last.
exact::Face rotated(exact::Face face) {
  while (face[2] != nullptr && (face[0] == nullptr || face[1] == nullptr))
    std::rotate(face.begin(), face.begin() + 1, face.end());
  return face;
}

struct Difference {
  double x, y, s;
};

Difference operator-(const Circle& u, const Circle& o) { return {u.x - o.x, u.y - o.y, u.r - o.r}; }
double cone(const Difference& u, const Difference& v) { return u.x * v.x + u.y * v.y - u.s * v.s; }
double size(const Difference& u) { return std::sqrt(u.x * u.x + u.y * u.y + u.s * u.s); }

/// The direction to infinity, normal to the tangent line to the left of a -> b: with d = b - a and g = <d, d> it is
/// -d.s (d.x, d.y) + sqrt(g) (-d.y, d.x).
///
/// Error: let l = |d|, computed within u each component. g <= l^2 is right within 6 u l^2, so sqrt(g) <= l within
/// 6 u l^2 / sqrt(g) + u l. Each component is a sum of two products of at most l^2: 2 * 4 u l^2, and l times the error
/// of the root; together under 20 u l^3 / sqrt(g).
FaceDisc discAtInfinity(const Circle& a, const Circle& b, int origin) {
  const Difference d = b - a;
  const double g = cone(d, d);
  FaceDisc disc;
  disc.origin = origin;
  disc.exists = true;
  const double l = size(d);
  const double root = std::sqrt(std::max(g, 0.0));
  disc.v = {-d.s * d.x - root * d.y, -d.s * d.y + root * d.x};
  disc.error = g > 12 * kUnit * l * l ? 20 * kUnit * l * l * l / root + kTiny : kUnknown;
  return disc;
}

/// The disc of circles o, u, v counter-clockwise, relative to o, by the formula of exact.cpp:
///   v = -sign(q) (g22 (g11 - g12) A' + g11 (g22 - g12) B' + N S),  w = 2 |q|,  q = <N,N>,  S = sqrt(g11 g22 g33).
/// Returns rho w, the distance from o times w, as well.
///
/// Error: let a = |A|, b = |B| in (x, y, s) space; differences are right within u relatively.
/// - g11 <= a^2, g12 <= a b, g22 <= b^2, g33 <= (a + b)^2, each within 6 u of that bound.
/// - M = g22 (g11 - g12) A' + ...: each of the two products is at most Q = a^2 b^2 (a + b), within 17 u Q; M within 36
/// u Q.
/// - N <= a b in each component, within 5 u a b.
/// - S^2 <= T^2 with T = a b (a + b), within 20 u T^2, so S is within 20 u T^2 / S + u S, provided that S^2 > 40 u T^2.
/// - N S within 20 u Q T / S + 7 u Q, since a b T = Q. The final sum adds 3 u Q.
///   As T >= S, each component of v, and rho w, is within 67 u Q T / S; 80 is used.
/// - q within 2 |N| sqrt(3) 5 u a b + 4 u |N|^2 + 75 u^2 a^2 b^2 < 24 u a b |N|_1 + 80 u^2 a^2 b^2.
/// Seen from another corner, w times a difference of at most max(a, b) is added: within
/// max(a, b) (error of w + 4 u w), and 2 u of the sum, which is below Q T / S terms already counted (80 against 67) and
/// 2 u max(a, b) w.
struct FiniteDisc {
  FaceDisc disc;
  double rho = 0;
  double rhoError = 0;
};

FiniteDisc finiteDisc(const Circle& o, const Circle& u, const Circle& v, int origin) {
  const Difference a = u - o;
  const Difference b = v - o;
  const Difference c = v - u;
  const double g11 = cone(a, a);
  const double g22 = cone(b, b);
  const double g12 = cone(a, b);
  const double g33 = cone(c, c);
  const Difference n = {a.y * b.s - a.s * b.y, a.s * b.x - a.x * b.s, a.x * b.y - a.y * b.x};
  const double q = cone(n, n);
  const double alpha = g22 * (g11 - g12);
  const double beta = g11 * (g22 - g12);
  const double s = std::sqrt(std::max(g11 * g22 * g33, 0.0));
  const double turn = q < 0 ? 1 : -1;

  FiniteDisc result;
  FaceDisc& disc = result.disc;
  disc.origin = origin;
  disc.v = {turn * (alpha * a.x + beta * b.x + n.x * s), turn * (alpha * a.y + beta * b.y + n.y * s)};
  disc.w = 2 * std::abs(q);
  result.rho = turn * (-alpha * a.s - beta * b.s + n.s * s);

  const double la = size(a);
  const double lb = size(b);
  const double ab = la * lb;
  const double t = ab * (la + lb);
  const double qError =
      24 * kUnit * ab * (std::abs(n.x) + std::abs(n.y) + std::abs(n.s)) + 80 * kUnit * kUnit * ab * ab + kTiny;
  if (std::abs(q) > qError && s * s > 40 * kUnit * t * t) {
    const double vError = 80 * kUnit * ab * t * (t / s) + kTiny;
    disc.error = vError + std::max(la, lb) * (2 * qError + 6 * kUnit * disc.w);
    result.rhoError = disc.error;
  } else {
    disc.error = result.rhoError = kUnknown;
  }
  return result;
}

bool equalRadii(std::span<const Circle> circles, const Predicates::Triple& face) {
  return circles[face[0]].r == circles[face[1]].r && circles[face[0]].r == circles[face[2]].r;
}

/// The error of f x g, with the components of f within e and those of g within h.
double crossError(Vector f, double e, Vector g, double h) {
  const double fSize = std::abs(f.x) + std::abs(f.y);
  const double gSize = std::abs(g.x) + std::abs(g.y);
  return (e * gSize + h * fSize + 2 * e * h + 3 * kUnit * fSize * gSize) * (1 + 0x1p-40) + kTiny;
}

}  // namespace

FaceDisc Predicates::disc(const Triple& face) {
  for (int i = 0; i < 3; ++i) {
    if (face[i] != kInfinity) continue;
    const int a = face[(i + 1) % 3];
    const int b = face[(i + 2) % 3];
    return discAtInfinity(circles_[a], circles_[b], a);
  }
  // Seen from the corner opposite the longest side both differences are short.
  const auto side = [&](int i) {
    const Vector v = between(circles_[face[(i + 1) % 3]], circles_[face[(i + 2) % 3]]);
    return dot(v, v);
  };
  const std::array<double, 3> sides = {side(0), side(1), side(2)};
  const auto at = static_cast<int>(std::max_element(sides.begin(), sides.end()) - sides.begin());
  const int i = face[at];
  FiniteDisc result = finiteDisc(circles_[i], circles_[face[(at + 1) % 3]], circles_[face[(at + 2) % 3]], i);

  // The disc exists if its centre is not at a negative distance from the smallest circle.
  const double smallest = std::min({circles_[face[0]].r, circles_[face[1]].r, circles_[face[2]].r});
  const double rho = result.rho + result.disc.w * (smallest - circles_[i].r);
  if (const int sign = signWithin(rho, result.rhoError); sign != 0) {
    ++counts_.filtered;
    result.disc.exists = sign > 0;
  } else {
    ++counts_.exact;
    result.disc.exists = exact::hasDisc(exactFace(circles_, face));
  }
  return result.disc;
}

int Predicates::cross(int from, const Triple& first, const FaceDisc& firstDisc, const Triple& second,
                      const FaceDisc& secondDisc) {
  const Vector f = direction(from, firstDisc);
  const Vector g = direction(from, secondDisc);
  const double error = crossError(f, firstDisc.error, g, secondDisc.error);
  if (const int sign = signWithin(circle_voronoi::cross(f, g), error); sign != 0) {
    ++counts_.filtered;
    return sign;
  }
  ++counts_.exact;
  return exact::crossSign(rotated(exactFace(circles_, first)), rotated(exactFace(circles_, second)), circles_[from]);
}

int Predicates::edgeOrder(int a, int b, int c, int d, const FaceDisc& abc, const FaceDisc& bad) {
  if (c == kInfinity || d == kInfinity) return 1;
  // Seen from the larger circle the bisector spans less than half a turn, so a cross product orders it.
  const bool fromA = circles_[a].r >= circles_[b].r;
  const Vector f = direction(fromA ? a : b, fromA ? bad : abc);
  const Vector g = direction(fromA ? a : b, fromA ? abc : bad);
  const double error = crossError(f, fromA ? bad.error : abc.error, g, fromA ? abc.error : bad.error);
  if (const int sign = signWithin(circle_voronoi::cross(f, g), error); sign != 0) {
    ++counts_.filtered;
    return sign;
  }
  if (equalRadii(circles_, {a, b, c}) && circles_[a].r == circles_[d].r) {
    ++counts_.inCircle;
    return -inCircle(circles_[a], circles_[b], circles_[c], circles_[d]);
  }
  ++counts_.exact;
  const exact::Face abcFace = exactFace(circles_, {a, b, c});
  const exact::Face badFace = exactFace(circles_, {b, a, d});
  return fromA ? exact::crossSign(badFace, abcFace, circles_[a]) : exact::crossSign(abcFace, badFace, circles_[b]);
}

int Predicates::quadrant(int from, const Triple& face, const FaceDisc& disc) {
  const Vector v = direction(from, disc);
  // Two products more, with factors below 2^10.
  const double error = (disc.error + 3 * kUnit * (std::abs(v.x) + std::abs(v.y))) * 2048;
  int x = signWithin(dot(kAxis, v), error);
  int y = signWithin(circle_voronoi::cross(kAxis, v), error);
  if (x != 0 && y != 0) {
    ++counts_.filtered;
  } else {
    ++counts_.exact;
    const exact::Face exactly = rotated(exactFace(circles_, face));
    if (x == 0) x = exact::directionSign(exactly, circles_[from], 0);
    if (y == 0) y = exact::directionSign(exactly, circles_[from], 1);
  }
  // Each quadrant owns the half-axis it starts with.
  if (y > 0) return x > 0 ? 0 : 1;
  if (y < 0) return x < 0 ? 2 : 3;
  return x > 0 ? 0 : 2;
}

bool Predicates::contains(const Circle& outer, const Circle& inner) {
  const Difference d = outer - inner;
  if (d.s < 0) return false;
  const double l = size(d);
  if (const int sign = signWithin(cone(d, d), 8 * kUnit * l * l + kTiny); sign != 0) return sign < 0;
  return exact::contains(outer, inner);
}

int Predicates::tangentSide(int a, int b, int c) {
  const Difference d = circles_[b] - circles_[a];
  const Difference e = circles_[c] - circles_[a];
  // With l = |d|, m = |e|: four products of at most l^2 m, and sqrt(g) within 6 u l^2 / sqrt(g).
  const double g = cone(d, d);
  const double l = size(d);
  if (g > 12 * kUnit * l * l) {
    const double root = std::sqrt(g);
    const double value = e.s * (d.x * d.x + d.y * d.y) - d.s * (d.x * e.x + d.y * e.y) + (d.x * e.y - d.y * e.x) * root;
    if (const int sign = signWithin(value, 60 * kUnit * l * l * size(e) * (l / root) + kTiny); sign != 0) {
      ++counts_.filtered;
      return sign;
    }
  }
  ++counts_.exact;
  return exact::tangentSide(circles_[a], circles_[b], circles_[c]);
}

}  // namespace circle_voronoi
