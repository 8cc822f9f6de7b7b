// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/curve.h"

namespace circle_voronoi {

/// A region's area and the integrals of x and y over it, relative to a point. Lengths are in a unit that is 1 except
/// for whole cells: their vertices may lie so far away that products of coordinates overflow.
struct Moments {
  double area = 0;
  double x = 0;
  double y = 0;
};

/// The region between a bounded arc and its chord, counted positive where the arc bends to the right of its chord.
/// The library of files takes it from this one.
CIRCLE_VORONOI_API Moments momentsOverChord(const EdgeCurve& curve, Point reference, double unit = 1);

/// Returns sinh(d) - d for d = ln(ratio) >= 0, with square roots alone. Exported because fits use it.
CIRCLE_VORONOI_API double sinhExcess(double ratio);

}  // namespace circle_voronoi
