// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "circle_voronoi/diagram.h"
#include "circle_voronoi/periodic_diagram.h"
#include "circle_voronoi/region.h"

namespace circle_voronoi {

/// An edge of the diagram inside the region, seen as a spring between its two cells.
struct Spring {
  CircleIndex left = {};
  CircleIndex right = {};
  double stiffness = 0;  ///< how fast area passes from the right cell to the left one as the left weight grows
  double length = 0;     ///< the distance between the centers of the two circles or images that share the edge
};

/// The areas of all cells inside a region, and their derivative by the weights: the derivative of the area of cell i by
/// the weight of j is minus the stiffness of their springs, and the derivative by its own weight is the sum of all its
/// springs.
struct CellMeasure {
  std::vector<double> areas;
  std::vector<Spring> springs;
};

CellMeasure measureCells(const Diagram& diagram, const Region& region);

/// Measures the cells of the given circles. A border between two images of one circle does not move, and is no spring.
/// Precondition: no circle is hidden.
CellMeasure measureCells(const PeriodicDiagram& periodic);

}  // namespace circle_voronoi
