// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace circle_voronoi {

/// A finite double other than zero as odd * 2^exponent. frexp and ldexp do not round.
struct OddPart {
  std::int64_t odd = 0;
  int exponent = 0;

  explicit OddPart(double value) {
    const double mantissa = std::frexp(value, &exponent);
    odd = static_cast<std::int64_t>(std::ldexp(mantissa, 53));
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(odd));
    odd >>= zeros;
    exponent += zeros - 53;
  }
};

/// The largest power of two of which all values given are multiples, and the bits they need in that unit.
class CommonUnit {
 public:
  void include(double value) {
    if (value == 0) return;
    const OddPart part(value);
    if (part.exponent < unit_) unit_ = part.exponent;
    const int top = part.exponent + static_cast<int>(std::bit_width(static_cast<std::uint64_t>(std::abs(part.odd))));
    if (top > top_) top_ = top;
  }

  /// Two to the power of this; 0 if all values are zero.
  int exponent() const { return top_ < unit_ ? 0 : unit_; }

  /// The bits of the largest magnitude.
  int bits() const { return top_ < unit_ ? 0 : top_ - unit_; }

  /// The value in this unit. Integer must have room for bits().
  template <class Integer>
  Integer in(double value) const {
    if (value == 0) return Integer(0);
    const OddPart part(value);
    // A product rather than a shift: a shift of a negative built-in integer reads worse, one of a library's may throw.
    Integer power(1);
    power <<= part.exponent - unit_;
    return Integer(part.odd) * power;
  }

 private:
  int unit_ = std::numeric_limits<int>::max();
  int top_ = std::numeric_limits<int>::min();
};

}  // namespace circle_voronoi
