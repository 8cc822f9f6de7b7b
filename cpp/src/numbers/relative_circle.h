// SPDX-License-Identifier: GPL-3.0-or-later
//
// Circles relative to one circle, in integers. Exact signs are computed from these numbers (exact.cpp).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "circle_voronoi/circle.h"
#include "common_unit.h"
#include "integer.h"

namespace circle_voronoi::exact {

/// A vector in (x, y, s) space with the cone x^2 + y^2 = s^2.
template <class Number>
struct Vector3 {
  Number x, y, s;
};
template <class Number>
Vector3(Number, Number, Number) -> Vector3<Number>;

template <class Number>
auto operator+(const Vector3<Number>& u, const Vector3<Number>& v) {
  return Vector3{u.x + v.x, u.y + v.y, u.s + v.s};
}
template <class Number>
auto operator-(const Vector3<Number>& u, const Vector3<Number>& v) {
  return Vector3{u.x - v.x, u.y - v.y, u.s - v.s};
}
template <class A, class B>
auto times(const A& f, const Vector3<B>& v) {
  return Vector3{f * v.x, f * v.y, f * v.s};
}
template <class A, class B>
auto cross(const Vector3<A>& u, const Vector3<B>& v) {
  return Vector3{u.y * v.s - u.s * v.y, u.s * v.x - u.x * v.s, u.x * v.y - u.y * v.x};
}
template <class A, class B>
auto planeCross(const Vector3<A>& u, const Vector3<B>& v) {
  return u.x * v.y - u.y * v.x;
}
template <class A, class B>
auto planeDot(const Vector3<A>& u, const Vector3<B>& v) {
  return u.x * v.x + u.y * v.y;
}
template <class A, class B>
auto lorentzDot(const Vector3<A>& u, const Vector3<B>& v) {
  return planeDot(u, v) - u.s * v.s;
}

/// A circle u seen from another: U and g_u. The point at infinity has U = 0, g_u = 1.
template <class Number>
struct RelativeCircle {
  Vector3<Number> v;
  decltype(Number() * Number()) g;
  bool isAtInfinity;

  RelativeCircle() : g(1), isAtInfinity(true) {}
  explicit RelativeCircle(const Vector3<Number>& difference)
      : v(difference), g(lorentzDot(v, v)), isAtInfinity(false) {}
};

using limbs::SignedWide;

template <class Number, std::size_t kCount>
using Differences = std::array<std::array<Number, 3>, kCount>;

/// Returns (x, y, r) of each circle minus that of circle o; zeros for the point at infinity.
template <class Number, std::size_t kCount, class Convert>
Differences<Number, kCount> differencesFrom(const Circle& o, const std::array<const Circle*, kCount>& circles,
                                            Convert in) {
  const std::array<Number, 3> origin = {in(o.x), in(o.y), in(o.r)};
  Differences<Number, kCount> result{};
  for (std::size_t i = 0; i < kCount; ++i) {
    if (const Circle* c = circles[i]; c != nullptr)
      result[i] = {in(c->x) - origin[0], in(c->y) - origin[1], in(c->r) - origin[2]};
  }
  return result;
}

template <int kLimbs, std::size_t kCount>
auto fixed(const Differences<SignedWide, kCount>& wide) {
  Differences<FixedInteger<kLimbs>, kCount> result;
  for (std::size_t i = 0; i < kCount; ++i) {
    for (std::size_t k = 0; k < 3; ++k) result[i][k] = FixedInteger<kLimbs>(wide[i][k]);
  }
  return result;
}

/// Calls formula(seen, exponent) with the given circles as seen from circle o. Numbers are in units of 2^exponent, and
/// in the smallest kind of integers that holds them.
template <std::size_t kCount, class Formula>
auto seenFrom(const Circle& o, const std::array<const Circle*, kCount>& circles, Formula formula) {
  CommonUnit unit;
  const auto include = [&](const Circle& c) {
    for (const double value : {c.x, c.y, c.r}) unit.include(value);
  };
  include(o);
  for (const Circle* c : circles) {
    if (c != nullptr) include(*c);
  }
  const auto seenAs = [&](const auto& differences) {
    using Number = std::decay_t<decltype(differences[0][0])>;
    std::array<RelativeCircle<Number>, kCount> seen;
    for (std::size_t i = 0; i < kCount; ++i) {
      const auto& [x, y, s] = differences[i];
      if (circles[i] != nullptr) seen[i] = RelativeCircle<Number>({x, y, s});
    }
    return formula(seen, unit.exponent());
  };
  constexpr int kOneLimb = 61;
  constexpr int kTwoLimbs = 125;
  if (unit.bits() >= kTwoLimbs) {
    // Numbers are multiples of 2^-96 up to 2^96, numbers of boxes up to 2^100 (limits.h).
    return seenAs(differencesFrom<FixedInteger<4>>(o, circles, [&](double value) {
      const OddPart part = unit.in(value);
      return FixedInteger<4>(part.odd, part.exponent);
    }));
  }
  const auto differences = differencesFrom<SignedWide>(o, circles, [&](double value) {
    const OddPart part = unit.in(value);
    return part.odd * (SignedWide{1} << part.exponent);
  });
  SignedWide all = 0;
  for (const auto& difference : differences) {
    for (const SignedWide d : difference) all |= d < 0 ? ~d : d;
  }
  return (all >> kOneLimb) == 0 ? seenAs(fixed<1>(differences)) : seenAs(fixed<2>(differences));
}

/// Returns the axis D of the disc of (o, u, v).
template <class Number>
auto axisOf(const RelativeCircle<Number>& u, const RelativeCircle<Number>& v) {
  return times(v.g, u.v) - times(u.g, v.v);
}

/// Returns the sign of p + q sqrt(d), given `norm`, the sign of p^2 - q^2 d. The functions `p` and `q`, which return
/// the signs of p and q, are called only where needed.
template <class P, class Q>
int signOf(int norm, P p, Q q) {
  if (norm < 0) return q();
  if (norm > 0) return p();
  const int both = p() + q();
  return both > 0 ? 1 : both < 0 ? -1 : 0;
}

/// Returns the squared length of the common tangents of two circles seen from a third; 1 if one is the point at
/// infinity.
template <class Number>
auto tangentSquare(const RelativeCircle<Number>& u, const RelativeCircle<Number>& v) {
  if (u.isAtInfinity || v.isAtInfinity) return RelativeCircle<Number>().g;
  const auto w = u.v - v.v;
  return lorentzDot(w, w);
}

/// The number mantissa * 2^exponent. Each operation is right to 53 bits.
class Floating {
 public:
  Floating(double mantissa, int exponent) {
    int shift = 0;
    mantissa_ = std::frexp(mantissa, &shift);
    exponent_ = exponent + shift;
  }
  explicit Floating(const LeadingBits& leading) : Floating(leading.value, leading.exponent) {}

  bool isPositive() const { return mantissa_ > 0; }
  double times(int powerOfTwo) const { return std::ldexp(mantissa_, exponent_ + powerOfTwo); }

  friend Floating operator-(const Floating& a) { return {-a.mantissa_, a.exponent_}; }
  friend Floating operator+(const Floating& a, const Floating& b) {
    if (a.mantissa_ == 0) return b;
    if (b.mantissa_ == 0) return a;
    const int exponent = std::max(a.exponent_, b.exponent_);
    return {a.times(-exponent) + b.times(-exponent), exponent};
  }
  friend Floating operator*(const Floating& a, const Floating& b) {
    return {a.mantissa_ * b.mantissa_, a.exponent_ + b.exponent_};
  }
  friend Floating operator/(const Floating& a, const Floating& b) {
    return {a.mantissa_ / b.mantissa_, a.exponent_ - b.exponent_};
  }
  friend Floating sqrt(const Floating& a) {
    const int odd = a.exponent_ & 1;
    return {std::sqrt(std::ldexp(a.mantissa_, odd)), (a.exponent_ - odd) / 2};
  }

 private:
  double mantissa_ = 0;
  int exponent_ = 0;
};

template <class Number>
Floating floating(const Number& value) {
  return Floating(value.leading());
}

}  // namespace circle_voronoi::exact
