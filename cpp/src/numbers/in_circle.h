// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vectors.h"

namespace circle_voronoi {

/// Exact tests of points, fast for the coordinates that people draw: integers and short decimals, whose ties no
/// floating-point filter decides.

/// 1 if a, b, c are counter-clockwise, -1 if clockwise, 0 if collinear.
int orientation(Point a, Point b, Point c);

/// 1 if d lies inside the circle through a, b, c, which are counter-clockwise; 0 if on it; -1 if outside.
int inCircle(Point a, Point b, Point c, Point d);

}  // namespace circle_voronoi
