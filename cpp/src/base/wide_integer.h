// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstdint>
#include <type_traits>

namespace circle_voronoi {

/// An integer of 128 bits in two's complement, for compilers that have none (portable.h). Results are modulo 2^128.
template <bool kIsSigned>
class WideInteger {
 public:
  WideInteger() = default;
  template <class Integer>
  requires std::is_integral_v<Integer> WideInteger(Integer value)
      : low_(static_cast<Half>(value)), high_(std::is_signed_v<Integer> && value < 0 ? ~Half{0} : 0) {}
  explicit WideInteger(const WideInteger<!kIsSigned>& other) : low_(other.low_), high_(other.high_) {}

  /// Conversions to built-in integers are modulo 2^64.
  explicit operator std::uint64_t() const { return low_; }
  explicit operator std::int64_t() const { return static_cast<std::int64_t>(low_); }

  friend bool operator==(const WideInteger& a, const WideInteger& b) = default;
  friend std::strong_ordering operator<=>(const WideInteger& a, const WideInteger& b) {
    return a.high_ == b.high_ ? a.low_ <=> b.low_ : a.top() <=> b.top();
  }

  friend WideInteger operator~(const WideInteger& a) { return {~a.low_, ~a.high_}; }
  friend WideInteger operator-(const WideInteger& a) { return ~a + 1; }
  friend WideInteger operator|(const WideInteger& a, const WideInteger& b) {
    return {a.low_ | b.low_, a.high_ | b.high_};
  }
  WideInteger& operator|=(const WideInteger& other) { return *this = *this | other; }

  friend WideInteger operator+(const WideInteger& a, const WideInteger& b) {
    const Half low = a.low_ + b.low_;
    return {low, a.high_ + b.high_ + (low < a.low_ ? 1 : 0)};
  }
  friend WideInteger operator-(const WideInteger& a, const WideInteger& b) { return a + ~b + 1; }
  friend WideInteger operator*(const WideInteger& a, const WideInteger& b) {
    const Half a0 = a.low_ & kQuarter, a1 = a.low_ >> 32, b0 = b.low_ & kQuarter, b1 = b.low_ >> 32;
    const Half least = a0 * b0;
    const Half middle = a1 * b0 + (least >> 32);
    const Half other = a0 * b1 + (middle & kQuarter);
    const Half carry = a1 * b1 + (middle >> 32) + (other >> 32);
    return {other << 32 | (least & kQuarter), carry + a.low_ * b.high_ + a.high_ * b.low_};
  }
  /// The quotient is rounded toward zero. Precondition: b is not 0.
  friend WideInteger operator/(const WideInteger& a, const WideInteger& b) requires kIsSigned {
    const WideInteger<false> dividend(a < 0 ? -a : a), divisor(b < 0 ? -b : b);
    WideInteger<false> quotient, rest;
    for (int bit = 127; bit >= 0; --bit) {
      rest = rest << 1 | (static_cast<Half>(dividend >> bit) & 1);
      if (rest < divisor) continue;
      rest = rest - divisor;
      quotient = quotient | WideInteger<false>(1) << bit;
    }
    const WideInteger result(quotient);
    return (a < 0) == (b < 0) ? result : -result;
  }

  /// Shifts take 0 to 127 bits.
  friend WideInteger operator<<(const WideInteger& a, int bits) {
    if (bits == 0) return a;
    if (bits >= 64) return {0, a.low_ << (bits - 64)};
    return {a.low_ << bits, a.high_ << bits | a.low_ >> (64 - bits)};
  }
  friend WideInteger operator>>(const WideInteger& a, int bits) {
    if (bits == 0) return a;
    if (bits >= 64) return {static_cast<Half>(a.top() >> (bits - 64)), kIsSigned && a < 0 ? ~Half{0} : 0};
    return {a.low_ >> bits | a.high_ << (64 - bits), static_cast<Half>(a.top() >> bits)};
  }

 private:
  template <bool>
  friend class WideInteger;
  using Half = std::uint64_t;
  static constexpr Half kQuarter = 0xffffffff;

  WideInteger(Half low, Half high) : low_(low), high_(high) {}

  /// The high half, with its sign.
  auto top() const { return static_cast<std::conditional_t<kIsSigned, std::int64_t, Half>>(high_); }

  Half low_ = 0;
  Half high_ = 0;
};

}  // namespace circle_voronoi
