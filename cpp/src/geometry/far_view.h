// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/curve.h"

namespace circle_voronoi {

/// A curve as it is to be drawn with what lies up to `reach` away from its origin. See edgeCurve: two circles too near
/// to each other to be told apart from there are moved apart; most curves stay as they are.
EdgeCurve seenFrom(const EdgeCurve& curve, double reach);

/// The parameter s >= 1 at which a branch is at a distance from its origin, in its unit: not below that of its apex.
double parameterAtDistance(const Bisector& bisector, double distance);

}  // namespace circle_voronoi
