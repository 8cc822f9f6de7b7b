// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/families.h"

namespace circle_voronoi {

// Circles like those of the paper's figures, of which it gives no coordinates.

/// A figure of the paper: circles of a family with seed 1, or some of its own.
struct Figure {
  std::string_view name;  ///< as "7a"
  std::string_view description;
  std::vector<Circle> (*make)();  ///< null: of the family
  Family family = Family::uniform;
  std::size_t count = 0;  ///< of the family
};

std::span<const Figure> figures();

/// One of `figures`, by its name.
const Figure& figureOf(std::string_view name);

std::vector<Circle> circlesOf(const Figure& figure);

/// Figure 5 b: two circles (0, 1) that are neighbours, though two others lie between their centres; figure 5 c: the
/// same with two rows between them.
std::vector<Circle> oneRowBetween();
std::vector<Circle> twoRowsBetween();

/// Figure 5 d: a very large circle (0) and a small one (1) that are neighbours, with tiny ones in layers around the
/// latter, so that many steps in the Delaunay graph of the centres are between them.
std::vector<Circle> layersBetween();

/// Figure 6: two circles (0, 1) that are neighbours although two tiny ones lie between their centres.
std::vector<Circle> sevenCircles();

/// Figure 9: an edge, of circles 0 and 2, that is short, and one that is a millionth as long as the circles are wide.
std::vector<Circle> shortEdge();
std::vector<Circle> nearlyNoEdge();

/// Figure 12: circles that intersect, three of them mutually (0, 1, 2), and one that is hidden (5, by 3).
std::vector<Circle> intersectingCircles();

/// Figure 13 b, after Lee et al. (2016): convex cells, pairs of circles with several edges, cells with two edges.
std::vector<Circle> severalEdges();

}  // namespace circle_voronoi
