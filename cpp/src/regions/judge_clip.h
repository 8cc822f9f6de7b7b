// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "arcs.h"
#include "cell_moments.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/region.h"
#include "crossings.h"

namespace circle_voronoi {

/// The parts of a clip that the judge examines.
struct ClipRecord {
  const Diagram& diagram;
  const Region& region;
  const ClipScope& scope;
  const Crossings& crossings;
  std::span<const std::int32_t> levels;  ///< the levels of the vertices in scope (Arcs)
  std::span<const Arc> arcs;             ///< the arcs of the edges with crossings
};

/// Judges a clip before its outlines and areas are derived, however it was made. Linear time. Returns a description of
/// the first fault, or nullptr:
/// - Each vertex has the level 0 or 1, and infinity has the level 0. Along each edge the level goes up at entries and
///   down at exits.
/// - Each crossing is an end of exactly one arc, at an entry its start and at an exit its end. An arc begins or ends at
///   a vertex only where that is inside, and then exactly one does.
/// - From each crossing the boundary goes on in the cell that it enters there, up to a crossing where it leaves this
///   cell. Each crossing ends one such piece. Each ring without crossings lies in one cell.
///
/// Then the border of each cell's part consists of closed loops, and both cells of an edge use the same ends of its
/// parts.
const char* faultOf(const ClipRecord& clip);

/// Judges the areas of a clip: none is negative and their sum is the area of the region, except for rounding.
const char* faultOf(const ClipRecord& clip, const CellMoments& moments);

}  // namespace circle_voronoi
