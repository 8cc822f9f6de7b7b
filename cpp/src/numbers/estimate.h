// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "arithmetic.h"
#include "infinity.h"

namespace circle_voronoi {

/// The largest relative error of one operation on doubles.
inline constexpr double kUnitRoundoff = 0x1p-53;

/// Circles are scaled by a power of two so that their largest number lies below 2^80, by at most 2^1000.
inline constexpr int kScaledExponent = 80;
inline constexpr int kLargestScaling = 1000;

/// More than underflow adds to any estimate. Each underflow is wrong by at most 2^-1074, and is then multiplied by
/// other numbers: validated coordinates stay below 2^81, so that the six that follow at most make it 2^(6 * 82 - 1074).
/// It is negligible where lengths exceed about 2^-40, that is 1e-36 of the whole. Shorter ones are scaled first
/// (short_lengths.h). Where some lengths of an estimate are shorter and others are not, integers may have to decide.
inline constexpr double kUnderflowError = 0x1p-500;

/// The error of what was not computed.
inline constexpr double kUnknownError = kInfinite;

/// A value in floating point and how far it may be from the exact one, short of an error that is relative to the value
/// itself and so does not change its sign.
struct Estimate {
  double value = 0;
  double error = kUnknownError;

  /// 0 if the error does not decide.
  int sign() const { return value > error ? 1 : value < -error ? -1 : 0; }
};

}  // namespace circle_voronoi
