// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "two_part.h"

namespace circle_voronoi {

/// A sum of many numbers that is right to rounding of the sum, not of each step (A. Neumaier, 1974).
class CompensatedSum {
 public:
  CompensatedSum& operator+=(double term) {
    const TwoPart next = sum(value_, term);
    value_ = next.value;
    rest_ += next.rest;
    return *this;
  }
  double value() const { return value_ + rest_; }

 private:
  double value_ = 0;
  double rest_ = 0;
};

}  // namespace circle_voronoi
