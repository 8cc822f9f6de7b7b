// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/curve.h"

namespace circle_voronoi {

/// Returns the curve to draw in a picture that extends up to `reach` from the curve's origin (edgeCurve). If the two
/// circles are too near to each other to be told apart at this scale, they are moved apart. Most curves do not change.
EdgeCurve seenFrom(const EdgeCurve& curve, double reach);

/// The parameter s >= 1 at which a branch is at a distance from its origin, in its unit: not below that of its apex.
double parameterAtDistance(const Bisector& bisector, double distance);

}  // namespace circle_voronoi
