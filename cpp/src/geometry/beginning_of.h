// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/diagram.h"
#include "circle_voronoi/point.h"
#include "vectors.h"

namespace circle_voronoi {

/// Returns the direction from a point of a cell to the beginning of a side, up to rounding.
Vector beginningOf(const Diagram& diagram, SideIndex side, Point from);

/// Returns this direction from the center of the cell.
Vector beginningOf(const Diagram& diagram, SideIndex side);

/// Returns whether turning counter-clockwise from `reference` one meets v no later than w.
bool isNoLater(Vector reference, Vector v, Vector w);

}  // namespace circle_voronoi
