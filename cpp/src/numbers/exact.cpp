// SPDX-License-Identifier: GPL-3.0-or-later
//
// Seen from a circle o, a disc that touches o at distance rho from its center c_o in the direction of the unit vector e
// touches circle u as well if and only if, with U = (x, y, s) = (c_u - c_o, r_u - r_o) and g_u = x^2 + y^2 - s^2,
//   (x, y) . e + s = g_u / (2 rho).
// So inversion about o, which takes u to the circle W_u = U / g_u, takes touching discs to tangent lines with the
// normal e and the offset t = 1 / (2 rho): the larger the offset, the smaller the disc. The point at infinity becomes W
// = 0.
//
// The disc of (o, u, v) counter-clockwise is the tangent line to the left of W_v -> W_u. With D = U g_v - V g_u:
//   e |D|^2 = -D.s (D.x, D.y) + sqrt(g_u g_v g_uv) (-D.y, D.x),
//   t |D|^2 = D.y N.x - D.x N.y + N.s sqrt(g_u g_v g_uv),  N = U x V,
// where |D|^2 = D.x^2 + D.y^2 is positive as are the g. Every sign is that of some p + q sqrt(d), and what decides if p
// and q differ, p^2 - q^2 d, is |D|^2 times a simpler number, called the norm below.
#include "exact.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "relative_circle.h"

namespace circle_voronoi::exact {
namespace {

/// Returns the sign of how far a circle z reaches beyond the tangent line with the axis D, where M is normal to the
/// plane of W_z and the two that the line touches. This is the sign of M.x D.y - M.y D.x + M.s sqrt(d). If M is on the
/// cone, all three have a common tangent.
template <class M, class D>
int reachSign(const Vector3<M>& m, const Vector3<D>& d) {
  return signOf(
      lorentzDot(m, m).sign(), [&] { return planeCross(m, d).sign(); }, [&] { return m.s.sign(); });
}

/// Returns the sign of <M, M>, with M as in `overlapSign`. M is g_u g_v g_z times the cross product of two sides of the
/// triangle W_u, W_v, W_z, so that <M, M> is -(g_u g_v g_z)^2 times the Gram determinant of these sides. A squared
/// side, such as <W_u - W_v, W_u - W_v>, is g_uv / (g_u g_v), where g_uv = 1 if one of the two is at infinity.
/// With A = g_uv g_z, B = g_vz g_u, C = g_zu g_v it follows that
///   4 <M, M> = (A + C - B)^2 - 4 A C,
/// J. Casey's condition that four circles touch one.
template <class Number>
int touchSign(const RelativeCircle<Number>& u, const RelativeCircle<Number>& v, const RelativeCircle<Number>& z) {
  const auto a = tangentSquare(u, v) * z.g;
  const auto b = tangentSquare(v, z) * u.g;
  const auto c = tangentSquare(z, u) * v.g;
  const auto sum = a + c - b;
  const auto twice = a * (c + c);
  return (sum * sum - (twice + twice)).sign();
}

/// Returns 1 if circle z overlaps the disc of (o, u, v), 0 if it touches the disc, -1 if it is clear of the disc. This
/// is reachSign with M = g_z (V x U) + g_v (U x Z) + g_u (Z x V).
template <class Number>
int overlapSign(const RelativeCircle<Number>& u, const RelativeCircle<Number>& v, const RelativeCircle<Number>& z) {
  return signOf(
      touchSign(u, v, z),
      [&] {
        const auto m = times(z.g, cross(v.v, u.v)) + times(v.g, cross(u.v, z.v)) + times(u.g, cross(z.v, v.v));
        return planeCross(m, axisOf(u, v)).sign();
      },
      [&] { return (z.g * planeCross(v.v, u.v) + v.g * planeCross(u.v, z.v) + u.g * planeCross(z.v, v.v)).sign(); });
}

/// Returns the vector times a power of two. Each component is right within 2^-51 of the largest, and none exceeds
/// 2^128.
template <class Number>
Vector3<double> normalized(const Vector3<Number>& v) {
  const std::array<LeadingBits, 3> parts = {v.x.leading(), v.y.leading(), v.s.leading()};
  const int exponent = std::max({parts[0].exponent, parts[1].exponent, parts[2].exponent});
  const auto scaled = [&](const LeadingBits& part) {
    return part.exponent == exponent ? part.value : std::ldexp(part.value, part.exponent - exponent);
  };
  return {scaled(parts[0]), scaled(parts[1]), scaled(parts[2])};
}

/// Returns whether the direction of the disc with the axis D lies to the left of E. This is the sign of E x e,
/// with p = D.s (D x E), q = D . E.
template <class D, class E>
bool isLeftOf(const Vector3<E>& e, const Vector3<D>& d) {
  // <D, D> is right within 2^-48 and its root within 2^-24. All other errors are smaller.
  const Vector3<double> a = normalized(d);
  const Vector3<double> b = normalized(e);
  const double value = a.s * planeCross(a, b) + planeDot(a, b) * std::sqrt(std::max(lorentzDot(a, a), 0.0));
  const double error = 0x1p-22 * planeDot(a, a) * (std::abs(b.x) + std::abs(b.y));
  if (std::abs(value) > error) return value > 0;
  const auto dot = planeDot(d, e);
  return signOf((d.s * d.s * planeDot(e, e) - dot * dot).sign(), [&] { return d.s.sign() * planeCross(d, e).sign(); },
                [&] { return dot.sign(); }) > 0;
}

/// Returns p + q root, where norm = (p^2 - q^2 root^2) / size. If p and q root cancel, size norm / (p - q root) does
/// not.
template <class P, class Q, class Norm>
Floating sumOf(const P& p, const Q& q, const Floating& root, const Norm& norm, const Floating& size) {
  const Floating a = floating(p);
  const Floating b = floating(q) * root;
  if (p.sign() * q.sign() >= 0) return a + b;
  return norm.sign() == 0 ? Floating(0, 0) : size * floating(norm) / (a + -b);
}

/// The tangent line that is the inverse of a disc, seen from circle o in units of 2^exponent: its normal e = (x, y) and
/// its offset t, both times `size`, which is |D|^2. From o, the center of the disc is e rho, with rho = 1 / (2 t).
struct InverseLine {
  Floating x, y, offset, size;
  int exponent;
};

/// Returns a point as a circle of radius 0, so that its g is a squared distance.
Circle pointAt(Point p) { return {p.x, p.y, 0}; }

InverseLine inverseLineOf(const Face& face, const Circle& o) {
  return seenFrom(o, othersOf(face, &o), [](const auto& seen, int exponent) -> InverseLine {
    const auto& [u, v] = seen;
    const auto d = axisOf(u, v);
    const auto n = cross(u.v, v.v);
    const auto w = u.v - v.v;
    const Floating root = sqrt(floating(u.g) * floating(v.g) * floating(lorentzDot(w, w)));
    const Floating size = floating(planeDot(d, d));
    const auto ss = d.s * d.s;
    return {sumOf(-(d.s * d.x), -d.y, root, ss - d.y * d.y, size), sumOf(-(d.s * d.y), d.x, root, ss - d.x * d.x, size),
            sumOf(planeCross(n, d), n.s, root, lorentzDot(n, n), size), size, exponent};
  });
}

}  // namespace

bool hasDisc(const Face& face) {
  if (std::find(face.begin(), face.end(), nullptr) != face.end()) return true;
  // The offset of the tangent line is positive: infinity, W = 0, does not reach beyond it.
  return seenFrom(*face[0], std::array{face[1], face[2]}, [](const auto& seen, int) {
           const auto& [u, v] = seen;
           return reachSign(cross(u.v, v.v), axisOf(u, v));
         }) > 0;
}

std::optional<Vertex> disc(const Face& face) {
  const Circle& o = *smallestOf(face);
  const auto [x, y, offset, size, exponent] = inverseLineOf(face, o);
  if (!offset.isPositive()) return std::nullopt;
  const int scaling = exponent - 1;
  return Vertex{o.x + (x / offset).times(scaling), o.y + (y / offset).times(scaling),
                (size / offset).times(scaling) - o.r};
}

std::optional<DiscPoint> discPoint(const Face& face) {
  const auto [x, y, offset, size, exponent] = inverseLineOf(face, *smallestOf(face));
  const DiscPoint point = {{(x / size).times(0), (y / size).times(0)}, (offset / size).times(1 - exponent)};
  if (!offset.isPositive() || !std::isfinite(point.w)) return std::nullopt;
  return point;
}

int directionSign(const Face& face, const Circle& from, int axis) {
  return seenFrom(
      from, othersOf(face, &from), [axis]<class Number>(const std::array<RelativeCircle<Number>, 2>& seen, int) {
        const Number kx(axis == 0 ? kAxisX : -kAxisY);
        const Number ky(axis == 0 ? kAxisY : kAxisX);
        const auto& [u, v] = seen;
        const auto d = axisOf(u, v);
        const auto turned = kx * d.y - ky * d.x;
        const auto norm = (d.s * d.s) * (kx * kx + ky * ky) - turned * turned;
        return signOf(
            norm.sign(), [&] { return -d.s.sign() * (kx * d.x + ky * d.y).sign(); }, [&] { return -turned.sign(); });
      });
}

int crossSign(const Face& first, const Face& second, const Circle& from) {
  const auto [u, v] = othersOf(first, &from);
  const auto [y, z] = othersOf(second, &from);
  // One of y and z is u or v.
  const bool isSecondNew = y == u || y == v;
  return seenFrom(from, std::array{u, v, y, z}, [&](const auto& seen, int) {
    const auto d = axisOf(seen[0], seen[1]);
    const auto e = axisOf(seen[2], seen[3]);
    // Let e1, e2 be the normals of the tangent lines to the left of D and E. Turned so that E lies at the angle 0, e2
    // lies at beta and e1 at delta, with |E| cos beta = -E.s, 0 < beta < pi. Then sin(beta - delta) has the sign of cos
    // delta - cos beta if 0 < delta < pi, and that of cos delta + cos beta if not. The former follows from how far one
    // of W_y, W_z reaches beyond the first line, which touches the other.
    if (isLeftOf(e, d)) {
      const int sign = overlapSign(seen[0], seen[1], seen[isSecondNew ? 3 : 2]);
      return isSecondNew ? -sign : sign;
    }
    const auto dot = planeDot(d, e);
    const auto sum = dot + d.s * e.s;
    return signOf((sum * sum - lorentzDot(d, d) * lorentzDot(e, e)).sign(),
                  [&] { return -(d.s * dot + e.s * planeDot(d, d)).sign(); }, [&] { return planeCross(d, e).sign(); });
  });
}

int overlapSign(const Face& face, const Circle* other, const Circle& from) {
  const auto [u, v] = othersOf(face, &from);
  return seenFrom(from, std::array{u, v, other},
                  [](const auto& seen, int) { return overlapSign(seen[0], seen[1], seen[2]); });
}

int touchSign(const Face& face, const Circle* other, const Circle& from) {
  const auto [u, v] = othersOf(face, &from);
  return seenFrom(from, std::array{u, v, other},
                  [](const auto& seen, int) { return touchSign(seen[0], seen[1], seen[2]); });
}

bool contains(const Circle& outer, const Circle& inner) {
  if (outer.r < inner.r) return false;
  return seenFrom(outer, std::array{&inner}, [](const auto& seen, int) { return seen[0].g.sign(); }) <= 0;
}

// With d = b - a, the result is e |d|^2, divided by the squared length of d in (x, y, s) space. The error is relative
// to the products, which are at most this square.
std::optional<Vector> tangentNormal(const Circle& a, const Circle& b) {
  const auto [x, y, s, g] = seenFrom(a, std::array{&b}, [](const auto& seen, int) {
    const auto& [v, square, isAtInfinity] = seen[0];
    return std::array{floating(v.x), floating(v.y), floating(v.s), floating(square)};
  });
  if (!g.isPositive()) return std::nullopt;
  const Floating root = sqrt(g);
  const Floating size = x * x + y * y + s * s;
  const Vector along = {(s * x / size).times(0), (s * y / size).times(0)};
  const Vector across = {(root * x / size).times(0), (root * y / size).times(0)};
  return Vector{-along.x - across.y, -along.y + across.x};
}

int tangentSide(const Circle& a, const Circle& b, const Circle& c) {
  return seenFrom(a, std::array{&b, &c}, [](const auto& seen, int) {
    const auto& [u, z] = seen;
    return reachSign(cross(u.v, z.v), u.v);
  });
}

// Along the line, the difference of two circles has some length. Across the line, it is the difference of their radii.
// Hence the Lorentz product of two differences is the product of their lengths along the line.
bool touchesBetween(const Circle& a, const Circle& b, const Circle& c) {
  const auto isSameWay = [](const Circle& from, const Circle& to, const Circle& circle) {
    return seenFrom(from, std::array{&to, &circle}, [](const auto& seen, int) {
             const auto& [u, z] = seen;
             return lorentzDot(u.v, z.v).sign();
           }) > 0;
  };
  return isSameWay(a, b, c) && isSameWay(b, a, c);
}

int orientation(Point a, Point b, Point c) {
  const std::array points = {pointAt(a), pointAt(b)};
  return seenFrom(pointAt(c), std::array{&points[0], &points[1]}, [](const auto& seen, int) {
    const auto& [u, v] = seen;
    return planeCross(u.v, v.v).sign();
  });
}

int inCircle(Point a, Point b, Point c, Point d) {
  const std::array points = {pointAt(a), pointAt(b), pointAt(c)};
  return seenFrom(pointAt(d), std::array{&points[0], &points[1], &points[2]}, [](const auto& seen, int) {
    const auto& [u, v, w] = seen;
    return (u.g * planeCross(v.v, w.v) + v.g * planeCross(w.v, u.v) + w.g * planeCross(u.v, v.v)).sign();
  });
}

}  // namespace circle_voronoi::exact
