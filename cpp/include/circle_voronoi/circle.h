// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/abi.h"

namespace circle_voronoi {

/// A circle with center (x, y) and radius r >= 0. A circle with r = 0 is a point. If radii are additive weights
/// (Options::weights), r may be negative.
///
/// The distance from a point p to circle i is signed: d_i(p) = |p - c_i| - r_i, which is negative inside the circle.
/// The y axis points up, and counter-clockwise is positive.
struct Circle {
  double x = 0;
  double y = 0;
  double r = 0;

  friend bool operator==(const Circle&, const Circle&) = default;
};

}  // namespace circle_voronoi
