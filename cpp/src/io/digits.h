// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

namespace circle_voronoi {

/// No number is written with more characters.
inline constexpr std::size_t kMostDigits = 32;

/// Writes the shortest decimal that reads back to the same bits, without an exponent where it is short enough so, and
/// returns the end of it. Precondition: there is room for kMostDigits characters.
char* writeDigits(char* to, double value);

/// Rounds numbers to decimals whose steps are a power of ten.
class DecimalGrid {
 public:
  /// Steps of at most `step`, as large as possible; without any, if `step` is below 1e-22.
  explicit DecimalGrid(double step);
  /// Steps with so many digits after the decimal point, from 0; without any, if there is no number, or it is one that
  /// leaves doubles as they are.
  explicit DecimalGrid(std::optional<int> digits);

  /// The largest change by `round`, or more.
  double error() const { return error_; }

  /// The double next to the decimal next to a value, which is written with its digits. A value of so many steps that
  /// no double tells them apart is returned as it is.
  double round(double value) const;

 private:
  double multiplier_ = 1;  ///< a power of ten, exact
  double divisor_ = 1;     ///< likewise; one of the two is 1
  double error_ = 0;
  bool isOff_ = true;
};

}  // namespace circle_voronoi
