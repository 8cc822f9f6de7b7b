// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "circle_voronoi/circle.h"
#include "dual.h"
#include "judge.h"

namespace circle_voronoi {

/// Makes the dual of a Voronoi diagram the only one: where more than three circles touch one disc, its faces are any
/// triangulation of the polygon of these circles, and become the one that is as if all circles shrank, by amounts of
/// different orders, the more the greater their centers are by x and then y. So the diagram does not depend on how it
/// was made, nor the faces of a disc on any but the circles that touch it, which a part of the circles has as well. It
/// is the rule of CGAL's Delaunay triangulations too: of equal circles nothing is to be changed.
///
/// A circle that shrinks leaves the disc that the others touch, and gets a face with its two neighbors on the polygon:
/// so an edge is right if, of the four circles around it, the greatest is not one of its ends.
///
/// The verdict is that of the judge. A dual that is right stays right, as the regions that the judge's theorem is about
/// stay the same sets of points; what its proof records of the faces that change is found again.
void settleTies(Dual& dual, Verdict& verdict, std::span<const Circle> circles, Predicates& predicates);

/// Whether an edge of length zero is right in that sense.
bool isSettledTie(const Dual& dual, int h, std::span<const Circle> circles);

}  // namespace circle_voronoi
