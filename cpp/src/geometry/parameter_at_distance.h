// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/curve.h"

namespace circle_voronoi {

/// The parameter s >= 1 at which a branch is at a distance from its origin: not below that of its apex.
double parameterAtDistance(const Bisector& bisector, double distance);

}  // namespace circle_voronoi
