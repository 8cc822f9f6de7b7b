// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "circle_voronoi/cells.h"
#include "ring.h"

namespace circle_voronoi {

/// Pieces of an outline inside a ring that follow each other without a gap, and the places on the ring where they begin
/// and end.
struct Chain {
  std::vector<OutlinePiece> pieces;
  double entry = 0;
  double exit = 0;
};

/// Returns a ring as a loop.
std::vector<OutlinePiece> wholeLoop(const Ring& ring);

/// Joins chains along the ring to the loops of what they enclose together. `depth` tells how far a point of the ring
/// lies inside what the chains are cut from; it is negative outside. There is at least one chain.
Outline joined(const Ring& ring, std::vector<Chain> chains, const std::function<double(Point)>& depth);

}  // namespace circle_voronoi
