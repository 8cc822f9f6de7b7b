// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vectors.h"

namespace circle_voronoi {

/// Returns whether d lies inside the circle through a, b, c, which are counter-clockwise; exact, and without ties: a
/// point on the circle counts as inside or outside by the coordinates of the four alone, as if each were lifted off the
/// paraboloid by far less than every point after it in lexicographic order (O. Devillers, M. Teillaud, "Perturbations
/// for Delaunay and weighted Delaunay 3D triangulations", 2011). The four are distinct.
bool isInPerturbedCircle(Point a, Point b, Point c, Point d);

}  // namespace circle_voronoi
