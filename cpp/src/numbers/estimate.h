// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "arithmetic.h"
#include "infinity.h"

namespace circle_voronoi {

/// The largest relative error of one operation on doubles.
inline constexpr double kUnitRoundoff = 0x1p-53;

/// Circles are scaled by a power of two, at most 2^1000, so that their largest number lies below 2^80.
inline constexpr int kScaledExponent = 80;
inline constexpr int kLargestScaling = 1000;

/// An upper bound on what underflow adds to any estimate. Each underflow is wrong by at most 2^-1074 and is then
/// multiplied by at most six other numbers. Validated coordinates stay below 2^81, so the result is at most
/// 2^(6 * 82 - 1074). It is negligible where lengths exceed about 2^-40, that is 1e-36 of the whole. Shorter lengths
/// are scaled first (short_lengths.h). If only some lengths of an estimate are shorter, integers may have to decide.
inline constexpr double kUnderflowError = 0x1p-500;

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
