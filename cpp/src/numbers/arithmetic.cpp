// SPDX-License-Identifier: GPL-3.0-or-later
#include "arithmetic.h"

namespace circle_voronoi {

namespace {

/// Returns a number but hides its value from the compiler, so that the tests below run when the program runs.
double unknown(double value) {
  volatile double hidden = value;
  return hidden;
}

}  // namespace

bool isArithmeticStandard() {
  const double one = unknown(1);
  const double half = unknown(0x1p-53);  // half of the step from 1 to the next number
  const double root = unknown(1 + 0x1p-27);
  const double square = unknown(1 + 0x1p-26);  // the square of `root`, rounded: the exact one is larger by 2^-54
  const double smallest = unknown(std::numeric_limits<double>::min());

  const bool isRoundedToNearest = one + half == one && one + 1.5 * half > one;
  const bool isInOrder = (one + half) - one == 0;
  const bool isFused = root * root - square != 0;
  const bool hasTinyNumbers = smallest / 2 > 0 && smallest / 2 * 2 == smallest;
  return isRoundedToNearest && isInOrder && !isFused && hasTinyNumbers;
}

}  // namespace circle_voronoi
