// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "circle_voronoi/circle.h"
#include "dual.h"
#include "judge.h"

namespace circle_voronoi {

/// Makes the dual of a Voronoi diagram unique. Where more than three circles touch one disc, any triangulation of the
/// polygon of these circles is a valid set of faces. This function chooses the triangulation that results if all
/// circles shrink by amounts of different orders: the greater the center by x and then y, the larger the amount. Hence
/// the diagram does not depend on the method that made it. The faces of a disc depend only on the circles that touch
/// it, so a subset with these circles has the same faces. CGAL's Delaunay triangulations follow the same rule, so
/// nothing needs to change for circles of equal radius.
///
/// A circle that shrinks leaves the disc that the others touch, and gets a face with its two neighbors on the polygon.
/// Hence an edge is right if neither end is the greatest of the four circles around it.
///
/// `verdict` must be the verdict of the judge on `dual`. A correct dual stays correct, because the regions in the
/// judge's theorem stay the same sets of points. The proof records of the faces that change are computed again.
void settleTies(Dual& dual, Verdict& verdict, std::span<const Circle> circles, Predicates& predicates);

/// Does the same for a dual of circles that touch one disc, or are lifted into one plane, in faces that are divided by
/// the edges `ties`. Returns the faces that change.
std::vector<int> settleTies(Dual& dual, std::span<const int> ties, std::span<const Circle> circles);

/// Returns whether an edge of length zero is right by the rule of `settleTies`.
bool isSettledTie(const Dual& dual, int h, std::span<const Circle> circles);

}  // namespace circle_voronoi
