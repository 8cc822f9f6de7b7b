// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/abi.h"

namespace circle_voronoi {

/// A Voronoi vertex (branch point): the center and the radius of the disc that touches its three circles from outside.
/// The center lies at distance r_i + r from the center of each circle i. The radius is negative where the three circles
/// overlap. For Metric::power the radius is the signed root of the power of the center.
struct Vertex {
  double x = 0;
  double y = 0;
  double r = 0;

  friend bool operator==(const Vertex&, const Vertex&) = default;
};

}  // namespace circle_voronoi
