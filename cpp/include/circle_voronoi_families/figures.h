// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi_families/families.h"

namespace circle_voronoi {

// Circles like in the paper's figures. The paper gives no coordinates.

/// A figure of the paper: its own circles, or circles of a family with seed 1.
struct Figure {
  std::string_view name;  ///< such as "figure-6"
  std::string_view description;
  std::vector<Circle> (*make)();  ///< null: take the family
  Family family = Family::uniform;
  std::size_t count = 0;  ///< the number of circles of the family
};

/// Returns all figures.
[[nodiscard]] CIRCLE_VORONOI_API std::span<const Figure> figures();

/// Returns the figure with a name. Precondition: there is one.
[[nodiscard]] CIRCLE_VORONOI_API const Figure& figureOf(std::string_view name);

/// Returns the circles of a figure.
[[nodiscard]] CIRCLE_VORONOI_API std::vector<Circle> circlesOf(const Figure& figure);

/// Figures 5 b and 5 c: two circles (0, 1) that are neighbors, although one row of circles, or two rows, lie between
/// their centers.
[[nodiscard]] CIRCLE_VORONOI_API std::vector<Circle> oneRowBetween();
[[nodiscard]] CIRCLE_VORONOI_API std::vector<Circle> twoRowsBetween();

/// Figure 5 d: a very large circle (0) and a small one (1) that are neighbors. Layers of tiny circles around the small
/// one put many steps of the Delaunay graph of the centers between the two.
[[nodiscard]] CIRCLE_VORONOI_API std::vector<Circle> layersBetween();

/// Figure 6: two circles (0, 1) that are neighbors, although two tiny ones lie between their centers.
[[nodiscard]] CIRCLE_VORONOI_API std::vector<Circle> sevenCircles();

/// Figure 9: a short edge between circles 0 and 2, and one that is a millionth as long as the circles are wide.
[[nodiscard]] CIRCLE_VORONOI_API std::vector<Circle> shortEdge();
[[nodiscard]] CIRCLE_VORONOI_API std::vector<Circle> nearlyNoEdge();

/// Figure 12: intersecting circles, three of them mutually (0, 1, 2), and a circle that is hidden (5, by 3).
[[nodiscard]] CIRCLE_VORONOI_API std::vector<Circle> intersectingCircles();

/// Figure 13 b, after Lee et al. (2016): convex cells, pairs of circles with several edges, cells with two edges.
[[nodiscard]] CIRCLE_VORONOI_API std::vector<Circle> severalEdges();

}  // namespace circle_voronoi
