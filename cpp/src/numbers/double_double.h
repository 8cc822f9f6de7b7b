// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "arithmetic.h"

namespace circle_voronoi {

/// A number as an unevaluated sum of two doubles, about 106 bits (T. J. Dekker, "A floating-point technique for
/// extending the available precision", 1971; bounds: M. Joldes, J.-M. Muller, V. Popescu, "Tight and rigorous error
/// bounds for basic building blocks of double-word arithmetic", 2017). Every operation here is right within 2^-100 of
/// its result, short of underflow. Splitting a factor overflows beyond 2^995, which validated coordinates to the tenth
/// power stay below. It needs neither a fused multiply-add nor extended registers, so it gives the same bits
/// everywhere.
class DoubleDouble {
 public:
  DoubleDouble() = default;
  DoubleDouble(double value) : high_(value) {}

  /// The exact difference of two doubles.
  static DoubleDouble difference(double a, double b) {
    const double d = a - b;
    const double bPart = a - d;
    return {d, (a - (d + bPart)) + (bPart - b)};
  }

  double high() const { return high_; }

  friend DoubleDouble operator-(const DoubleDouble& a) { return {-a.high_, -a.low_}; }

  friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble s = sum(a.high_, b.high_);
    const DoubleDouble t = sum(a.low_, b.low_);
    const DoubleDouble v = quickSum(s.high_, s.low_ + t.high_);
    return quickSum(v.high_, t.low_ + v.low_);
  }

  friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }

  friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble p = product(a.high_, b.high_);
    return quickSum(p.high_, p.low_ + (a.high_ * b.low_ + a.low_ * b.high_));
  }

  /// The square root of a number that is not negative.
  friend DoubleDouble sqrt(const DoubleDouble& a) {
    if (!(a.high_ > 0)) return {};
    const double root = std::sqrt(a.high_);
    const DoubleDouble rest = a - product(root, root);
    return quickSum(root, rest.high_ / (2 * root));
  }

 private:
  DoubleDouble(double high, double low) : high_(high), low_(low) {}

  static DoubleDouble quickSum(double a, double b) {
    const double s = a + b;
    return {s, b - (s - a)};
  }

  static DoubleDouble sum(double a, double b) {
    const double s = a + b;
    const double bPart = s - a;
    return {s, (a - (s - bPart)) + (b - bPart)};
  }

  static DoubleDouble product(double a, double b) {
    constexpr double kSplitter = 0x1p27 + 1;
    const auto split = [](double v) {
      const double scaled = kSplitter * v;
      const double high = scaled - (scaled - v);
      return DoubleDouble{high, v - high};
    };
    const double p = a * b;
    const DoubleDouble u = split(a);
    const DoubleDouble v = split(b);
    return {p, ((u.high_ * v.high_ - p) + u.high_ * v.low_ + u.low_ * v.high_) + u.low_ * v.low_};
  }

  double high_ = 0;
  double low_ = 0;
};

}  // namespace circle_voronoi
