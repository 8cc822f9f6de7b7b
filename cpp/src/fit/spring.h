// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/curve.h"

namespace circle_voronoi {

/// Returns how fast the area between two cells changes as the difference of their weights changes: the integral of
/// 1 / |u_left - u_right| along an arc of their bisector, where u is the unit vector from a center to the point.
/// Precondition: the arc is bounded.
double stiffness(const EdgeCurve& arc);

/// Returns the same for a border of a power diagram between centers at a distance: its length over twice the distance.
double stiffnessOfPowers(const EdgeCurve& border, double distance);

}  // namespace circle_voronoi
