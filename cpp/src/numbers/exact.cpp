// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <initializer_list>

#include "integers.h"

namespace circle_voronoi::exact {
namespace {

using Integer = boost::multiprecision::cpp_int;

int sign(const Integer& a) { return a.sign(); }

/// p + q sqrt(d), d >= 0.
int sign(const Integer& p, const Integer& q, const Integer& d) {
  const int sp = sign(p);
  const int sq = d.is_zero() ? 0 : sign(q);
  if (sp == 0 || sq == 0 || sp == sq) return sp != 0 ? sp : sq;
  return sp * sign(Integer(p * p - q * q * d));
}

/// (x, y, r) in units of a common power of two.
struct Integers {
  Integer x, y, s;
};

Integers operator-(const Integers& u, const Integers& v) { return {u.x - v.x, u.y - v.y, u.s - v.s}; }
Integers operator+(const Integers& u, const Integers& v) { return {u.x + v.x, u.y + v.y, u.s + v.s}; }
Integers operator*(const Integer& f, const Integers& v) { return {f * v.x, f * v.y, f * v.s}; }

Integers cross(const Integers& u, const Integers& v) {
  return {u.y * v.s - u.s * v.y, u.s * v.x - u.x * v.s, u.x * v.y - u.y * v.x};
}
Integer cone(const Integers& u, const Integers& v) { return u.x * v.x + u.y * v.y - u.s * v.s; }

/// Converts circles to integers in a unit that all of them share.
class Scale {
 public:
  void include(const Circle& c) {
    for (const double value : {c.x, c.y, c.r}) unit_.include(value);
  }
  void include(const Face& face) {
    for (const Circle* c : face) {
      if (c != nullptr) include(*c);
    }
  }
  Integers of(const Circle& c) const {
    return {unit_.in<Integer>(c.x), unit_.in<Integer>(c.y), unit_.in<Integer>(c.r)};
  }
  /// The unit is two to the power of this.
  int exponent() const { return unit_.exponent(); }

 private:
  CommonUnit unit_;
};

/// A direction (P + Q sqrt(d)) / w, w > 0; s is the distance from the centre of the circle looked from. At infinity w
/// is of no account.
struct Direction {
  Integers p;
  Integers q;
  Integer d;
  Integer w = 1;
  bool exists = true;
};

/// From circle o to the disc of (o, u, v).
///
/// With A = u - o, B = v - o in (x, y, r) space, <.,.> the cone product, g11 = <A,A>, g22 = <B,B>, g12 = <A,B> and
/// N = A x B, the centre X solves <A',X> = g11 / 2, <B',X> = g22 / 2, <X,X> = 0, where ' negates the third component:
///   X = -(g22 (g11 - g12) A' + g11 (g22 - g12) B' + N sqrt(g11 g22 g33)) / (2 <N,N>),  g33 = <A - B, A - B>.
/// That root is the counter-clockwise disc. If <N,N> = 0 (a line touches all three circles) one root is at infinity and
/// the other is rational.
Direction toDisc(const Integers& o, const Integers& u, const Integers& v) {
  const Integers a = u - o;
  const Integers b = v - o;
  const Integers n = cross(a, b);
  const Integer g11 = cone(a, a);
  const Integer g22 = cone(b, b);
  const Integer qa = cone(n, n);
  Direction x;
  if (!qa.is_zero()) {
    const Integer g12 = cone(a, b);
    const Integers ap = {a.x, a.y, -a.s};
    const Integers bp = {b.x, b.y, -b.s};
    const Integer alpha = g22 * (g11 - g12);
    const Integer beta = g11 * (g22 - g12);
    const Integer turn = qa.sign() < 0 ? 1 : -1;
    x.p = turn * (alpha * ap + beta * bp);
    x.q = turn * n;
    x.d = g11 * g22 * (g11 + g22 - 2 * g12);
    x.w = 2 * abs(qa);
    return x;
  }
  // Twice the squared length of N times the point of the line nearest the origin.
  const Integers base = g11 * cross(b, n) + g22 * cross(n, a);
  const Integer along = cone(base, n);
  if (along.sign() >= 0) {
    x.exists = false;
    return x;
  }
  x.p = Integer(-2 * along) * base + cone(base, base) * n;
  x.d = 0;
  x.w = -4 * along * (n.x * n.x + n.y * n.y + n.s * n.s);
  return x;
}

/// From the disc as seen from o to the disc as seen from another corner.
Direction seenFrom(const Circle& from, const Face& face, const Scale& scale) {
  const auto at = static_cast<std::size_t>(std::find(face.begin(), face.end(), &from) - face.begin());
  const Circle* u = face[(at + 1) % 3];
  const Circle* v = face[(at + 2) % 3];
  if (u != nullptr && v != nullptr) return toDisc(scale.of(from), scale.of(*u), scale.of(*v));
  // The normal of the line to the left of a -> b, d = b - a: -d.s (d.x, d.y) + sqrt(g) (-d.y, d.x).
  const Integers a = v == nullptr ? scale.of(from) : scale.of(*v);
  const Integers b = v == nullptr ? scale.of(*u) : scale.of(from);
  const Integers d = b - a;
  return {{-d.s * d.x, -d.s * d.y, 0}, {-d.y, d.x, 0}, cone(d, d), 1};
}

Direction seenFrom(const Circle& from, const Face& face) {
  Scale scale;
  scale.include(face);
  return seenFrom(from, face, scale);
}

/// mantissa * 2^exponent, the mantissa of at most 53 bits.
struct Floating {
  double mantissa = 0;
  int exponent = 0;
};

int bitCount(const Integer& a) { return a.is_zero() ? 0 : static_cast<int>(msb(abs(a))) + 1; }

Integer shifted(const Integer& a, int bits) { return bits >= 0 ? Integer(a << bits) : Integer(a >> -bits); }

/// (p + q sqrt(d)) / w to 50 bits.
Floating quotient(const Integer& p, const Integer& q, const Integer& d, const Integer& w) {
  if (sign(p, q, d) == 0) return {};
  // p and q sqrt(d) may cancel: more bits of the root until enough are left. The root is wrong by less than one.
  Integer sum = p;
  int bits = 0;
  if (!q.is_zero() && !d.is_zero()) {
    constexpr int kEnough = 60;
    for (bits = 64;; bits *= 2) {
      const Integer root = sqrt(shifted(Integer(q * q * d), 2 * bits));
      sum = shifted(p, bits) + (q.sign() < 0 ? Integer(-root) : root);
      if (bitCount(sum) >= kEnough) break;
    }
  }
  constexpr int kQuotientBits = 53;
  const int shift = kQuotientBits - bitCount(sum) + bitCount(w);
  const Integer magnitude = shift >= 0 ? Integer(shifted(abs(sum), shift) / w) : Integer(abs(sum) / shifted(w, -shift));
  // 53 or 54 bits; the last one may go.
  const double mantissa = static_cast<double>(static_cast<std::uint64_t>(magnitude));
  return {sum.sign() < 0 ? -mantissa : mantissa, -shift - bits};
}

}  // namespace

bool hasDisc(const Face& face) {
  const Circle* smallest = nullptr;
  for (const Circle* c : face) {
    if (c == nullptr) return true;
    if (smallest == nullptr || c->r < smallest->r) smallest = c;
  }
  const Direction x = seenFrom(*smallest, face);
  return x.exists && sign(x.p.s, x.q.s, x.d) >= 0;
}

Vertex disc(const Face& face) {
  Scale scale;
  scale.include(face);
  const Circle& from = *face[0];
  const Direction x = seenFrom(from, face, scale);
  if (!x.exists || x.d.sign() < 0) return {};
  const Integers o = scale.of(from);
  std::array<Floating, 3> numbers = {quotient(x.p.x + o.x * x.w, x.q.x, x.d, x.w),
                                     quotient(x.p.y + o.y * x.w, x.q.y, x.d, x.w),
                                     quotient(x.p.s - o.s * x.w, x.q.s, x.d, x.w)};
  constexpr int kMostExponent = 512 - 54;
  int beyond = 0;
  for (Floating& number : numbers) {
    number.exponent += scale.exponent();
    if (number.mantissa != 0) beyond = std::max(beyond, number.exponent - kMostExponent);
  }
  const auto value = [&](const Floating& number) { return std::ldexp(number.mantissa, number.exponent - beyond); };
  return {value(numbers[0]), value(numbers[1]), value(numbers[2])};
}

int directionSign(const Face& face, const Circle& from, int axis) {
  const Direction x = seenFrom(from, face);
  const Integer ex = axis == 0 ? kAxisX : -kAxisY;
  const Integer ey = axis == 0 ? kAxisY : kAxisX;
  return sign(Integer(x.p.x * ex + x.p.y * ey), Integer(x.q.x * ex + x.q.y * ey), x.d);
}

int crossSign(const Face& first, const Face& second, const Circle& from) {
  Scale scale;
  scale.include(first);
  scale.include(second);
  const Direction f = seenFrom(from, first, scale);
  const Direction g = seenFrom(from, second, scale);
  // The cross product is p1 + q1 sqrt(f.d) + (p2 + q2 sqrt(f.d)) sqrt(g.d).
  const Integer p1 = f.p.x * g.p.y - f.p.y * g.p.x;
  const Integer q1 = f.q.x * g.p.y - f.q.y * g.p.x;
  const Integer p2 = f.p.x * g.q.y - f.p.y * g.q.x;
  const Integer q2 = f.q.x * g.q.y - f.q.y * g.q.x;
  const int s1 = sign(p1, q1, f.d);
  const int s2 = g.d.is_zero() ? 0 : sign(p2, q2, f.d);
  if (s1 == 0 || s2 == 0 || s1 == s2) return s1 != 0 ? s1 : s2;
  return s1 * sign(Integer(p1 * p1 + q1 * q1 * f.d - (p2 * p2 + q2 * q2 * f.d) * g.d),
                   Integer(2 * (p1 * q1 - p2 * q2 * g.d)), f.d);
}

bool contains(const Circle& outer, const Circle& inner) {
  if (outer.r < inner.r) return false;
  Scale scale;
  scale.include(outer);
  scale.include(inner);
  const Integers d = scale.of(outer) - scale.of(inner);
  return cone(d, d).sign() <= 0;
}

int tangentSide(const Circle& a, const Circle& b, const Circle& c) {
  Scale scale;
  for (const Circle* circle : {&a, &b, &c}) scale.include(*circle);
  const Integers d = scale.of(b) - scale.of(a);
  const Integers e = scale.of(c) - scale.of(a);
  // |d|^2 (n . (e.x, e.y) + e.s) with n = (-d.s (d.x, d.y) + sqrt(g) (-d.y, d.x)) / |d|^2.
  const Integer p = e.s * (d.x * d.x + d.y * d.y) - d.s * (d.x * e.x + d.y * e.y);
  const Integer q = d.x * e.y - d.y * e.x;
  return sign(p, q, cone(d, d));
}

}  // namespace circle_voronoi::exact
