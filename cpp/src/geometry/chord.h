// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/curve.h"

namespace circle_voronoi {

/// Whether the polyline of a bounded arc is its chord. The library of files takes it from this one.
CIRCLE_VORONOI_API bool isNearChord(const EdgeCurve& curve, double tolerance);

}  // namespace circle_voronoi
