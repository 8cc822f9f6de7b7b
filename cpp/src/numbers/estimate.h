// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "arithmetic.h"
#include "infinity.h"

namespace circle_voronoi {

/// The largest relative error of one operation on doubles.
inline constexpr double kUnitRoundoff = 0x1p-53;

/// An upper bound on what underflow adds to any estimate.
///
/// Numbers are multiples of 2^-96 (limits.h), and rounding keeps multiples. So a product of ten differences is 0 or at
/// least 2^-960, and a sum of such products is a multiple of 2^-960. A root replaces a product of the same size. Only a
/// sum of which one term is a root can cancel further, to 2^-53 of its smallest term. The product of two such sums, as
/// in crossOf, and its error bound are the only numbers that may then underflow, each by at most 2^-1075, and they are
/// not multiplied again.
inline constexpr double kUnderflowError = 0x1p-1060;

/// The error of a value that was not computed.
inline constexpr double kUnknownError = kInfinite;

/// A floating-point value and a bound on its distance from the exact one. The bound leaves out errors that are relative
/// to the value itself, because they do not change its sign.
struct Estimate {
  double value = 0;
  double error = kUnknownError;

  /// Returns the sign, or 0 if the error bound does not decide.
  int sign() const { return value > error ? 1 : value < -error ? -1 : 0; }
};

}  // namespace circle_voronoi
