// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/abi.h"

namespace circle_voronoi {

struct Point {
  double x = 0;
  double y = 0;

  friend bool operator==(const Point&, const Point&) = default;
};

/// A difference of points, or a direction of any length.
struct Vector {
  double x = 0;
  double y = 0;

  friend bool operator==(const Vector&, const Vector&) = default;
};

}  // namespace circle_voronoi
