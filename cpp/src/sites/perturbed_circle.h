// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vectors.h"

namespace circle_voronoi {

/// Returns whether d lies inside the circle through a, b, c, which are counter-clockwise. The result is exact, and
/// there are no ties: the coordinates of the four points alone decide whether a point on the circle counts as inside,
/// as if each were lifted off the paraboloid by far less than every point after it in lexicographic order (O.
/// Devillers, M. Teillaud, "Perturbations for Delaunay and weighted Delaunay 3D triangulations", 2011).
/// Precondition: the four points are distinct.
bool isInPerturbedCircle(Point a, Point b, Point c, Point d);

}  // namespace circle_voronoi
