// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/curve.h"

namespace circle_voronoi {

/// Returns how fast the area between two cells changes as the difference of their weights changes: the integral of
/// 1 / |u_left - u_right| along an arc of their bisector, where u is the unit vector from a center to the point.
/// Precondition: the arc is bounded.
double stiffness(const EdgeCurve& arc);

}  // namespace circle_voronoi
