// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/final_cells.h"
#include "circle_voronoi/point.h"

namespace circle_voronoi {

/// The points p with normal . p >= offset. The normal has length 1 up to rounding. A half-plane with an infinite offset
/// is the whole plane.
struct KnownHalfPlane {
  Vector normal;
  double offset = 0;
};

/// Does the work of `finalCells` for any convex region in place of the box: inside(p) is the smallest of normal . p -
/// offset. The theorem and its proof also hold here. The largest radius may be negative here. `knowsVertices`: the
/// vertices are those that `compute` has just made, so their discs need not be computed anew.
/// Precondition: the indices of the diagram exist, and `circles` are its circles, rounded (limits.h).
FinalCells finalCellsInside(std::span<const Circle> circles, const Diagram& diagram,
                            std::span<const KnownHalfPlane> known, double maxRadius, bool knowsVertices = false);

}  // namespace circle_voronoi
