// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "circle_voronoi/circle.h"

namespace circle_voronoi::results {

// Circles like those of the paper's figures, of which it gives no coordinates.

/// Figure 5 d: a very large circle (0) and a small one (1) that are neighbours, with tiny ones in layers around the
/// latter, so that many steps in the Delaunay graph of the centres are between them.
std::vector<Circle> layersBetween();

/// Figure 6: two circles (0, 1) that are neighbours although two tiny ones lie between their centres.
std::vector<Circle> sevenCircles();

/// Figure 12: circles that intersect, three of them mutually (0, 1, 2), and one that is hidden (5, by 3).
std::vector<Circle> intersectingCircles();

/// Figure 13 b, after Lee et al. (2016): convex cells, pairs of circles with several edges, cells with two edges.
std::vector<Circle> severalEdges();

}  // namespace circle_voronoi::results
