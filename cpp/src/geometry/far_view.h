// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/curve.h"

namespace circle_voronoi {

/// A curve as it is to be drawn with what lies up to `reach` away from its origin. See edgeCurve: two circles too near
/// to each other to be told apart from there are moved apart; most curves stay as they are.
EdgeCurve seenFrom(const EdgeCurve& curve, double reach);

/// The parameter s >= 1 at which a branch is at the distance apex + c rise from the origin, rise = cosh t - 1.
double parameterAtRise(double rise);

}  // namespace circle_voronoi
