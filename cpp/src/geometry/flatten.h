// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "circle_voronoi/curve.h"

namespace circle_voronoi {

// Arcs of edges as polylines that make good polygons of cells. The functions are exported because the library for files
// calls them.

/// Returns whether the triangle p, q, r is counter-clockwise, up to rounding.
CIRCLE_VORONOI_API bool isLeftTurn(Point p, Point q, Point r);

/// Returns whether the step from p to q turns around both foci of an arc, by less than half a turn.
CIRCLE_VORONOI_API bool turnsAround(Point left, Point right, Point p, Point q);

/// Returns the points of an arc from `start` to `end`, which are its ends up to rounding. They are the points of
/// polyline() and further ones, so that each step turns around both foci unless it is as short as rounding. Then a
/// cell's polygon is star-shaped from the center of its circle, like the cell, and does not cross itself.
CIRCLE_VORONOI_API std::vector<Point> pointsBetween(const EdgeCurve& curve, Point start, Point end, double tolerance);

/// Returns whether pointsBetween has only the ends.
CIRCLE_VORONOI_API bool isOneStep(const EdgeCurve& curve, double tolerance);

}  // namespace circle_voronoi
