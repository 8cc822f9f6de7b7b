// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <initializer_list>
#include <span>

#include "circle_voronoi/point.h"
#include "common_unit.h"
#include "integer.h"
#include "two_part.h"

namespace circle_voronoi {

/// Points, and weights of a power diagram, in integers of a common unit. Weights are squares of numbers of that unit,
/// or multiples of 2^-192 up to 2^192 (limits.h).
class WeightedNumbers {
 public:
  WeightedNumbers(std::initializer_list<Point> points, std::initializer_list<TwoPart> weights)
      : WeightedNumbers(std::span(points.begin(), points.size()), std::span(weights.begin(), weights.size())) {}
  WeightedNumbers(std::span<const Point> points, std::span<const TwoPart> weights) {
    CommonUnit unit;
    for (const Point p : points) {
      unit.include(p.x);
      unit.include(p.y);
    }
    CommonUnit squareUnit;
    for (const TwoPart& weight : weights) {
      squareUnit.include(weight.value);
      squareUnit.include(weight.rest);
    }
    exponent_ = unit.exponent();
    // Weights are areas, so their exponents are halved.
    if (squareUnit.bits() > 0) {
      const int half = squareUnit.exponent() >= 0 ? squareUnit.exponent() / 2 : (squareUnit.exponent() - 1) / 2;
      exponent_ = unit.bits() > 0 ? std::min(exponent_, half) : half;
    }
  }

  struct Difference {
    FixedInteger<4> x, y;
  };
  Difference between(Point from, Point to) const { return {in(to.x) - in(from.x), in(to.y) - in(from.y)}; }
  FixedInteger<8> weight(const TwoPart& weight) const { return square(weight.value) + square(weight.rest); }

  /// Points and weights are in units of 2^exponent() and its square.
  int exponent() const { return exponent_; }

 private:
  FixedInteger<4> in(double value) const {
    const OddPart part(value);
    return FixedInteger<4>(part.odd, part.odd == 0 ? 0 : part.exponent - exponent_);
  }
  FixedInteger<8> square(double value) const {
    const OddPart part(value);
    return FixedInteger<8>(part.odd, part.odd == 0 ? 0 : part.exponent - 2 * exponent_);
  }

  int exponent_ = 0;
};

inline FixedInteger<8> dotOf(const WeightedNumbers::Difference& u, const WeightedNumbers::Difference& v) {
  return u.x * v.x + u.y * v.y;
}
inline FixedInteger<8> crossOf(const WeightedNumbers::Difference& u, const WeightedNumbers::Difference& v) {
  return u.x * v.y - u.y * v.x;
}

}  // namespace circle_voronoi
