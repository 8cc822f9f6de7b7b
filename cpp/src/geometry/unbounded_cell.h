// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/cells.h"
#include "circle_voronoi/diagram.h"

namespace circle_voronoi {

/// Returns whether a cell with this outline is unbounded. Hidden circles have an empty outline, too, but no cell.
inline bool isUnbounded(const Diagram& diagram, CircleIndex circle, const Outline& whole) {
  return whole.empty() && diagram.hasCell(circle);
}

}  // namespace circle_voronoi
