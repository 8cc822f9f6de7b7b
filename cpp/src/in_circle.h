// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/circle.h"

namespace circle_voronoi {

/// 1 if the centre of d lies inside the circle through the centres of a, b, c, which are counter-clockwise; 0 if on it;
/// -1 if outside. Exact, and fast for the coordinates that people draw: integers and short decimals.
int inCircle(const Circle& a, const Circle& b, const Circle& c, const Circle& d);

}  // namespace circle_voronoi
