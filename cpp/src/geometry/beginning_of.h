// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/diagram.h"
#include "vectors.h"

namespace circle_voronoi {

/// Returns the direction from the center of a cell in which a side begins, up to rounding.
Vector beginningOf(const Diagram& diagram, SideIndex side);

/// Returns whether turning counter-clockwise from `reference` one meets v no later than w.
bool isNoLater(Vector reference, Vector v, Vector w);

}  // namespace circle_voronoi
