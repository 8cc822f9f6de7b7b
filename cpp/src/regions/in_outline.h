// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "circle_voronoi/cells.h"

namespace circle_voronoi {

/// Returns whether a loop of an outline winds around a point, which does not lie on it.
bool hasInLoop(const std::vector<OutlinePiece>& loop, Point p);

}  // namespace circle_voronoi
