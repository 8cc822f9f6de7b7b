// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "at.h"
#include "portable.h"

namespace circle_voronoi {

/// The number value * 2^exponent, with a value that is right to 51 bits.
struct LeadingBits {
  double value = 0;
  int exponent = 0;
};

namespace limbs {

using Limb = std::uint64_t;
using Wide = UnsignedInt128;
using SignedWide = Int128;
inline constexpr int kBits = 64;

}  // namespace limbs

/// An integer in two's complement with kLimbs limbs. Its value is a polynomial in numbers that share a unit, without
/// rounding and without overflow. For numbers of at most 64 n - 3 bits, take n limbs times the degree. The spare bits
/// leave room for the sums of the formulas' terms. Only integers of equal degree are added, which is enough for every
/// sign that does not depend on the unit.
template <int kLimbs>
class FixedInteger {
 public:
  FixedInteger() = default;
  explicit FixedInteger(limbs::SignedWide value) {
    limbs_[0] = static_cast<Limb>(value);
    if constexpr (kLimbs > 1) limbs_[1] = static_cast<Limb>(value >> limbs::kBits);
    for (int i = 2; i < kLimbs; ++i) limbs_[at(i)] = value < 0 ? ~Limb{0} : 0;
  }

  /// Makes value * 2^shift, with shift >= 0.
  FixedInteger(std::int64_t value, int shift) {
    const int zeros = shift / limbs::kBits;
    const auto shifted = static_cast<limbs::SignedWide>(value) * (limbs::SignedWide{1} << shift % limbs::kBits);
    limbs_[at(zeros)] = static_cast<Limb>(shifted);
    if (zeros + 1 < kLimbs) limbs_[at(zeros + 1)] = static_cast<Limb>(shifted >> limbs::kBits);
    for (int i = zeros + 2; i < kLimbs; ++i) limbs_[at(i)] = value < 0 ? ~Limb{0} : 0;
  }

  int sign() const {
    if (static_cast<std::int64_t>(limbs_[kLimbs - 1]) < 0) return -1;
    Limb any = 0;
    for (const Limb limb : limbs_) any |= limb;
    return any != 0 ? 1 : 0;
  }

  LeadingBits leading() const {
    const bool isNegative = mask() != 0;
    const FixedInteger magnitude = isNegative ? -*this : *this;
    int top = kLimbs - 1;
    while (top > 0 && magnitude.limbs_[at(top)] == 0) --top;
    double value = static_cast<double>(magnitude.limbs_[at(top)]);
    if (top > 0) value = value * 0x1p64 + static_cast<double>(magnitude.limbs_[at(--top)]);
    return {isNegative ? -value : value, limbs::kBits * top};
  }

  friend FixedInteger operator-(const FixedInteger& a) { return FixedInteger() - a; }
  friend FixedInteger operator+(const FixedInteger& a, const FixedInteger& b) {
    if constexpr (kLimbs <= 2) return ofWide(a.wide() + b.wide());
    FixedInteger result;
    Limb carry = 0;
    for (int i = 0; i < kLimbs; ++i) {
      const Wide total = static_cast<Wide>(a.limbs_[at(i)]) + b.limbs_[at(i)] + carry;
      result.limbs_[at(i)] = static_cast<Limb>(total);
      carry = static_cast<Limb>(total >> limbs::kBits);
    }
    return result;
  }
  friend FixedInteger operator-(const FixedInteger& a, const FixedInteger& b) {
    if constexpr (kLimbs <= 2) return ofWide(a.wide() - b.wide());
    FixedInteger result;
    Limb borrow = 0;
    for (int i = 0; i < kLimbs; ++i) {
      const Wide rest = static_cast<Wide>(a.limbs_[at(i)]) - b.limbs_[at(i)] - borrow;
      result.limbs_[at(i)] = static_cast<Limb>(rest);
      borrow = static_cast<Limb>(rest >> limbs::kBits) & 1;
    }
    return result;
  }

  template <int kOther>
  FixedInteger<kLimbs + kOther> operator*(const FixedInteger<kOther>& other) const {
    if constexpr (kLimbs + kOther == 2) return FixedInteger<2>::ofWide(wide() * other.wide());
    FixedInteger<kLimbs + kOther> result;
    auto& out = result.limbs_;
    for (int i = 0; i < kLimbs; ++i) {
      Limb carry = 0;
      for (int j = 0; j < kOther; ++j) {
        const Wide total = static_cast<Wide>(limbs_[at(i)]) * other.limbs_[at(j)] + out[at(i + j)] + carry;
        out[at(i + j)] = static_cast<Limb>(total);
        carry = static_cast<Limb>(total >> limbs::kBits);
      }
      out[at(i + kOther)] = carry;
    }
    // The loop takes a negative factor as unsigned, so as too large by two to the power of its bits. Subtract the
    // excess.
    result.takeAway(other.limbs_, kLimbs, mask());
    result.takeAway(limbs_, kOther, other.mask());
    return result;
  }

 private:
  template <int>
  friend class FixedInteger;
  using Limb = limbs::Limb;
  using Wide = limbs::Wide;

  /// Returns a number of one or two limbs modulo 2^128.
  Wide wide() const {
    if constexpr (kLimbs == 1) return static_cast<Wide>(static_cast<std::int64_t>(limbs_[0]));
    return static_cast<Wide>(limbs_[1]) << limbs::kBits | limbs_[0];
  }
  static FixedInteger ofWide(Wide value) {
    FixedInteger result;
    result.limbs_[0] = static_cast<Limb>(value);
    if constexpr (kLimbs == 2) result.limbs_[1] = static_cast<Limb>(value >> limbs::kBits);
    return result;
  }

  Limb mask() const { return Limb{0} - (limbs_[kLimbs - 1] >> (limbs::kBits - 1)); }

  template <std::size_t kCount>
  void takeAway(const std::array<Limb, kCount>& value, int from, Limb mask) {
    Limb borrow = 0;
    for (std::size_t i = 0; i < kCount; ++i) {
      Limb& limb = limbs_[i + static_cast<std::size_t>(from)];
      const Wide rest = static_cast<Wide>(limb) - (value[i] & mask) - borrow;
      limb = static_cast<Limb>(rest);
      borrow = static_cast<Limb>(rest >> limbs::kBits) & Limb{1};
    }
  }

  std::array<Limb, std::size_t{kLimbs}> limbs_{};
};

}  // namespace circle_voronoi
