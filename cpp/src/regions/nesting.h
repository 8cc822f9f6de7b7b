// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "circle_voronoi/cells.h"
#include "valid_polygons.h"

namespace circle_voronoi {

/// Returns for each hole of a part of a cell the loop around it. The cell is star-shaped around `center`, and a piece
/// of a loop is a part of its border or of a side of a region. Takes O(n log n) steps, and more only where rounding has
/// made loops cross.
std::vector<std::size_t> loopsAround(const Outline& loops, std::span<const PointRing> holes, Point center);

}  // namespace circle_voronoi
