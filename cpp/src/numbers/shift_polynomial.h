// SPDX-License-Identifier: GPL-3.0-or-later
//
// Signs of places that are moved by a tiny shift (e, f), where e is positive but smaller than any number and f is
// positive but smaller than any power of e. A sign is that of a polynomial in e and f: the sign of its first
// coefficient that is not 0, where all powers of e come before f.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "relative_circle.h"

namespace circle_voronoi {

/// A polynomial in e and f with coefficients of some limbs, of degree kDegree at most.
template <int kLimbs, int kDegree>
class ShiftPolynomial {
 public:
  using Coefficient = FixedInteger<kLimbs>;
  static constexpr std::size_t kCount = static_cast<std::size_t>((kDegree + 1) * (kDegree + 2) / 2);

  ShiftPolynomial() = default;
  explicit ShiftPolynomial(const Coefficient& constant) { coefficients_[0] = constant; }

  /// Returns the place of the coefficient of e^ePower f^fPower.
  static constexpr std::size_t placeOf(int ePower, int fPower) {
    return static_cast<std::size_t>(fPower * (kDegree + 1) - fPower * (fPower - 1) / 2 + ePower);
  }
  Coefficient& at(int ePower, int fPower) { return coefficients_[placeOf(ePower, fPower)]; }
  const Coefficient& at(int ePower, int fPower) const { return coefficients_[placeOf(ePower, fPower)]; }

  int sign() const {
    for (const Coefficient& coefficient : coefficients_) {
      if (const int its = coefficient.sign(); its != 0) return its;
    }
    return 0;
  }

  /// Returns the polynomial as one of a higher degree.
  template <int kOther>
  ShiftPolynomial<kLimbs, kOther> raised() const {
    ShiftPolynomial<kLimbs, kOther> result;
    for (int f = 0; f <= kDegree; ++f) {
      for (int e = 0; e + f <= kDegree; ++e) result.at(e, f) = at(e, f);
    }
    return result;
  }

 private:
  std::array<Coefficient, kCount> coefficients_;
};

template <int kLimbs, int kA, int kB>
auto operator+(const ShiftPolynomial<kLimbs, kA>& a, const ShiftPolynomial<kLimbs, kB>& b) {
  auto result = a.template raised<std::max(kA, kB)>();
  for (int f = 0; f <= kB; ++f) {
    for (int e = 0; e + f <= kB; ++e) result.at(e, f) = result.at(e, f) + b.at(e, f);
  }
  return result;
}
template <int kLimbs, int kDegree>
auto operator-(const ShiftPolynomial<kLimbs, kDegree>& a) {
  ShiftPolynomial<kLimbs, kDegree> result;
  for (int f = 0; f <= kDegree; ++f) {
    for (int e = 0; e + f <= kDegree; ++e) result.at(e, f) = -a.at(e, f);
  }
  return result;
}
template <int kLimbs, int kA, int kB>
auto operator-(const ShiftPolynomial<kLimbs, kA>& a, const ShiftPolynomial<kLimbs, kB>& b) {
  return a + -b;
}
template <int kLimbsA, int kA, int kLimbsB, int kB>
auto operator*(const ShiftPolynomial<kLimbsA, kA>& a, const ShiftPolynomial<kLimbsB, kB>& b) {
  ShiftPolynomial<kLimbsA + kLimbsB, kA + kB> result;
  for (int f = 0; f <= kA; ++f) {
    for (int e = 0; e + f <= kA; ++e) {
      if (a.at(e, f).sign() == 0) continue;
      for (int g = 0; g <= kB; ++g) {
        for (int d = 0; d + g <= kB; ++d) result.at(e + d, f + g) = result.at(e + d, f + g) + a.at(e, f) * b.at(d, g);
      }
    }
  }
  return result;
}

/// A vector whose components are numbers or polynomials.
template <class Number>
struct PlaneVector {
  Number x, y;
};
template <class Number>
PlaneVector(Number, Number) -> PlaneVector<Number>;
template <class A, class B>
auto dot(const PlaneVector<A>& u, const PlaneVector<B>& v) {
  return u.x * v.x + u.y * v.y;
}
template <class A, class B>
auto cross(const PlaneVector<A>& u, const PlaneVector<B>& v) {
  return u.x * v.y - u.y * v.x;
}

/// Takes places as they are.
struct AsGiven {
  template <class Number>
  static auto fixed(const exact::Vector3<Number>& v) {
    return PlaneVector{v.x, v.y};
  }
  template <class Number>
  static auto moved(const exact::Vector3<Number>& v) {
    return PlaneVector{v.x, v.y};
  }
  template <class Number>
  static Number number(const Number& value) {
    return value;
  }
  template <class Number>
  static Number linear(const Number& value) {
    return value;
  }
};

/// Takes places of a region as they are after the shift.
struct AsMoved {
  template <int kLimbs>
  static auto fixed(const exact::Vector3<FixedInteger<kLimbs>>& v) {
    return PlaneVector{number(v.x), number(v.y)};
  }
  template <int kLimbs>
  static auto moved(const exact::Vector3<FixedInteger<kLimbs>>& v) {
    ShiftPolynomial<kLimbs, 1> x(v.x);
    ShiftPolynomial<kLimbs, 1> y(v.y);
    x.at(1, 0) = FixedInteger<kLimbs>(1);
    y.at(0, 1) = FixedInteger<kLimbs>(1);
    return PlaneVector{x, y};
  }
  template <int kLimbs>
  static auto number(const FixedInteger<kLimbs>& value) {
    return ShiftPolynomial<kLimbs, 0>(value);
  }
  /// Returns a number as a polynomial of degree 1.
  template <int kLimbs, int kDegree>
  static auto linear(const ShiftPolynomial<kLimbs, kDegree>& value) {
    return value.template raised<1>();
  }
};

/// A sign that is not 0 after the shift, and whether it is 0 without the shift.
struct ShiftedSign {
  int sign = 0;
  bool isTie = false;
};

}  // namespace circle_voronoi
