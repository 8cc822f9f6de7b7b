// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

#include "bit_cast.h"

namespace circle_voronoi {

/// A finite double as odd * 2^exponent; zero has odd = 0.
struct OddPart {
  std::int64_t odd = 0;
  int exponent = 0;

  explicit OddPart(double value) {
    constexpr int kFractionBits = 52;
    constexpr int kLeastExponent = -1074;
    const auto bits = bitCast<std::uint64_t>(value);
    auto mantissa = bits & ((std::uint64_t{1} << kFractionBits) - 1);
    const auto biased = static_cast<int>((bits >> kFractionBits) & 0x7ff);
    if (biased != 0) mantissa |= std::uint64_t{1} << kFractionBits;
    if (mantissa == 0) return;
    const int zeros = std::countr_zero(mantissa);
    odd = static_cast<std::int64_t>(mantissa >> zeros);
    if ((bits >> 63) != 0) odd = -odd;
    exponent = kLeastExponent + (biased != 0 ? biased - 1 : 0) + zeros;
  }
};

/// The largest power of two that divides all included values, and the number of bits that they need in this unit.
class CommonUnit {
 public:
  void include(double value) {
    const OddPart part(value);
    if (part.odd == 0) return;
    if (part.exponent < unit_) unit_ = part.exponent;
    const auto magnitude = static_cast<std::uint64_t>(part.odd < 0 ? -part.odd : part.odd);
    const int top = part.exponent + static_cast<int>(std::bit_width(magnitude));
    if (top > top_) top_ = top;
  }

  /// Returns the exponent of this power of two; 0 if all values are zero.
  int exponent() const { return top_ < unit_ ? 0 : unit_; }

  /// Returns the number of bits of the largest magnitude in this unit.
  int bits() const { return top_ < unit_ ? 0 : top_ - unit_; }

  /// Returns an included value in this unit.
  OddPart in(double value) const {
    OddPart part(value);
    if (part.odd != 0) part.exponent -= unit_;
    return part;
  }

 private:
  int unit_ = std::numeric_limits<int>::max();
  int top_ = std::numeric_limits<int>::min();
};

}  // namespace circle_voronoi
