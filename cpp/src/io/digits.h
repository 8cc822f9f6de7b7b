// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

namespace circle_voronoi {

/// No number is written with more characters.
inline constexpr std::size_t kMostDigits = 32;

/// Writes the shortest decimal that reads back to the same bits, without an exponent if it is short enough without one,
/// and returns a pointer past its end. Precondition: there is room for kMostDigits characters.
char* writeDigits(char* to, double value);

/// Rounds numbers to decimals whose steps are a power of ten.
class DecimalGrid {
 public:
  /// Uses the largest steps of at most `step`. Rounds nothing if `step` is below 1e-22.
  explicit DecimalGrid(double step);
  /// Uses steps of 10^-digits. Rounds nothing without `digits`, or if no double needs that many.
  explicit DecimalGrid(std::optional<int> digits);

  /// The largest change by `round`, or more.
  double error() const { return error_; }

  /// Returns the double nearest to the nearest decimal, whose shortest text is that decimal. Returns values unchanged
  /// if they are so large that doubles cannot tell steps apart.
  double round(double value) const;

 private:
  double multiplier_ = 1;  ///< a power of ten, exact
  double divisor_ = 1;     ///< a power of ten, exact; one of the two is 1
  double error_ = 0;
  bool isOff_ = true;
};

}  // namespace circle_voronoi
