// SPDX-License-Identifier: GPL-3.0-or-later
#include "arithmetic.h"

namespace circle_voronoi {

namespace {

/// A number of which the compiler knows no more than that it is one.
double unknown(double value) {
  volatile double hidden = value;
  return hidden;
}

}  // namespace

bool isArithmeticStandard() {
  const double one = unknown(1);
  const double half = unknown(0x1p-53);  // half of the step from 1 to the next number
  const double root = unknown(1 + 0x1p-27);
  const double square = unknown(1 + 0x1p-26);  // of the root, rounded: the rest is 2^-54
  const double smallest = unknown(std::numeric_limits<double>::min());

  const bool isRoundedToNearest = one + half == one && one + 1.5 * half > one;
  const bool isInOrder = (one + half) - one == 0;
  const bool isFused = root * root - square != 0;
  const bool hasTinyNumbers = smallest / 2 > 0 && smallest / 2 * 2 == smallest;
  return isRoundedToNearest && isInOrder && !isFused && hasTinyNumbers;
}

}  // namespace circle_voronoi
