// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/point.h"

namespace circle_voronoi::oracle {

/// The Voronoi diagram by CGAL's Apollonius graph with exact decisions, without coordinates, hull and stats, and
/// without the hiders of hidden circles.
///
/// This library is compiled with GMP and directed rounding, so nothing of CGAL is visible outside.
[[gnu::visibility("default")]] Diagram exactDiagram(std::span<const Circle> circles);

/// The faces of CGAL's Delaunay triangulation with exact decisions, kNone for the point at infinity, each beginning
/// with its smallest corner, sorted. Among equal points, the first is the corner.
[[gnu::visibility("default")]] std::vector<std::array<int, 3>> delaunayFaces(std::span<const Point> points);

/// The finite faces of CGAL's regular triangulation in exact numbers, of the centers with squared radii as weights, or
/// with the radii as weights. Of circles with one center, the first of the largest weight is the corner.
[[gnu::visibility("default")]] std::vector<std::array<int, 3>> regularFaces(std::span<const Circle> circles,
                                                                            bool weights);

}  // namespace circle_voronoi::oracle
