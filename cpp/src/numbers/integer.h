// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace circle_voronoi {

/// The number value * 2^exponent, with a value that is right to 51 bits.
struct LeadingBits {
  double value = 0;
  int exponent = 0;
};

/// Arithmetic on integers of any size. A number is an array of limbs, the least significant first and no leading zeros.
/// Its size is the count of limbs, negated for a negative number.
namespace limbs {

using Limb = std::uint64_t;
__extension__ using Wide = unsigned __int128;
__extension__ using SignedWide = __int128;
inline constexpr int kBits = 64;

/// Writes a + b to `out`, which has room for one limb more than either has and overlaps neither. Returns its size.
int sum(const Limb* a, int aSize, const Limb* b, int bSize, Limb* out);

/// Writes a * b to `out`, which has room for the limbs of both and overlaps neither. Returns its size.
int product(const Limb* a, int aSize, const Limb* b, int bSize, Limb* out);

/// Writes value * 2^shift to `out`, with shift >= 0. Returns its size.
int assign(std::int64_t value, int shift, Limb* out);

LeadingBits leading(const Limb* a, int size);

}  // namespace limbs

// Each class below is an integer that is a polynomial of the given degree in numbers that share a unit, without
// rounding. It allocates no memory and does not overflow. Only integers of equal degree are added, which is enough for
// every sign that does not depend on the unit.

/// An integer for values of any doubles. It has memory for the largest such value but takes time for the actual one.
template <int kDegree>
class Integer {
 public:
  Integer() = default;
  Integer(const Integer& other) : size_(other.size_) { copy(other); }
  Integer& operator=(const Integer& other) {
    size_ = other.size_;
    copy(other);
    return *this;
  }

  /// Makes value * 2^shift, with shift >= 0.
  explicit Integer(std::int64_t value, int shift = 0) { size_ = limbs::assign(value, shift, limbs_.data()); }

  int sign() const { return size_ > 0 ? 1 : size_ < 0 ? -1 : 0; }
  LeadingBits leading() const { return limbs::leading(limbs_.data(), size_); }

  friend Integer operator-(const Integer& a) {
    Integer result = a;
    result.size_ = -a.size_;
    return result;
  }
  friend Integer operator+(const Integer& a, const Integer& b) { return a.plus(b, b.size_); }
  friend Integer operator-(const Integer& a, const Integer& b) { return a.plus(b, -b.size_); }

  template <int kOther>
  Integer<kDegree + kOther> operator*(const Integer<kOther>& other) const {
    Integer<kDegree + kOther> result;
    result.size_ = limbs::product(limbs_.data(), size_, other.limbs_.data(), other.size_, result.limbs_.data());
    return result;
  }

 private:
  template <int>
  friend class Integer;
  /// The number of limbs for degree 1: doubles reach from 2^-1074 to 2^1024.
  static constexpr int kLimbsOfOne = (1024 + 1074) / limbs::kBits + 1;
  /// Room for constants and sums.
  static constexpr int kLimbsToSpare = 2;

  void copy(const Integer& other) {
    for (int i = 0; i < (size_ < 0 ? -size_ : size_); ++i) limbs_[i] = other.limbs_[i];
  }

  Integer plus(const Integer& other, int otherSize) const {
    Integer result;
    result.size_ = limbs::sum(limbs_.data(), size_, other.limbs_.data(), otherSize, result.limbs_.data());
    return result;
  }

  int size_ = 0;
  std::array<limbs::Limb, kDegree * kLimbsOfOne + kLimbsToSpare> limbs_;  // limbs beyond size_ are not set
};

/// An integer in two's complement with kLimbs limbs, several times faster than Integer. For numbers of at most 64 n - 3
/// bits, take n limbs times the degree. The spare bits leave room for the sums of the formulas' terms.
template <int kLimbs>
class FixedInteger {
 public:
  FixedInteger() = default;
  explicit FixedInteger(limbs::SignedWide value) {
    limbs_[0] = static_cast<Limb>(value);
    if constexpr (kLimbs > 1) limbs_[1] = static_cast<Limb>(value >> limbs::kBits);
    for (int i = 2; i < kLimbs; ++i) limbs_[i] = value < 0 ? ~Limb{0} : 0;
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
    while (top > 0 && magnitude.limbs_[top] == 0) --top;
    double value = static_cast<double>(magnitude.limbs_[top]);
    if (top > 0) value = value * 0x1p64 + static_cast<double>(magnitude.limbs_[--top]);
    return {isNegative ? -value : value, limbs::kBits * top};
  }

  friend FixedInteger operator-(const FixedInteger& a) { return FixedInteger() - a; }
  friend FixedInteger operator+(const FixedInteger& a, const FixedInteger& b) {
    if constexpr (kLimbs <= 2) return ofWide(a.wide() + b.wide());
    FixedInteger result;
    Limb carry = 0;
    for (int i = 0; i < kLimbs; ++i) {
      const Wide total = static_cast<Wide>(a.limbs_[i]) + b.limbs_[i] + carry;
      result.limbs_[i] = static_cast<Limb>(total);
      carry = static_cast<Limb>(total >> limbs::kBits);
    }
    return result;
  }
  friend FixedInteger operator-(const FixedInteger& a, const FixedInteger& b) {
    if constexpr (kLimbs <= 2) return ofWide(a.wide() - b.wide());
    FixedInteger result;
    Limb borrow = 0;
    for (int i = 0; i < kLimbs; ++i) {
      const Wide rest = static_cast<Wide>(a.limbs_[i]) - b.limbs_[i] - borrow;
      result.limbs_[i] = static_cast<Limb>(rest);
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
        const Wide total = static_cast<Wide>(limbs_[i]) * other.limbs_[j] + out[i + j] + carry;
        out[i + j] = static_cast<Limb>(total);
        carry = static_cast<Limb>(total >> limbs::kBits);
      }
      out[i + kOther] = carry;
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
      borrow = static_cast<Limb>(rest >> limbs::kBits) & 1;
    }
  }

  std::array<Limb, kLimbs> limbs_{};
};

}  // namespace circle_voronoi
