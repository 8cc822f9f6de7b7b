// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/vertex.h"
#include "weighted_point.h"

namespace circle_voronoi {

/// Returns the center and the radius of the circle that is orthogonal to those of three weighted points, which are not
/// collinear: the point of equal power to all three and the root of this power. Where the power is negative, the radius
/// is minus the root of minus the power. The place is right to 36 bits of its distances from the points, and the
/// power to 36 bits of itself.
Vertex radicalCenter(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c);

}  // namespace circle_voronoi
