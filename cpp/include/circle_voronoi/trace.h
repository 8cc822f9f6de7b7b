// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/diagram.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// What happens in the event loop of the touching disc method (paper, Algorithms 2 and 3), in order.
enum class TraceKind {
  antipodalDiscAccepted,  ///< the disc is empty; its two directed edges follow
  antipodalDiscUsed,      ///< rejected: a footpoint lies on an arc already used for the diagram
  antipodalDiscNotEmpty,  ///< rejected: it meets `circles[2]`
  threeTouchDiscFormed,   ///< put into the queue
  threeTouchDiscStale,    ///< discarded: its directed edges are gone or no longer adjacent
  branchDisc,             ///< a three-touch disc that is empty: `vertex` is made
  directedEdgePlaced,     ///< from circles[0] to circles[1]; `disc` is its disc of R_min
  directedEdgeDeleted,    ///< from circles[0] to circles[1]
  segmentFinished,  ///< the Voronoi segment of the directed edge circles[0] to circles[1]; `disc` is its disc of R_max
};

/// One event. Discs are given in the units of the input; circles are input indices, kNone where there is none.
/// A three-touch disc names its circles in the paper's order, clockwise: directed edges 0 to 1, 1 to 2 (and 2 to 0).
struct TraceEvent {
  TraceKind kind = TraceKind::antipodalDiscAccepted;
  Vertex disc;
  std::array<CircleIndex, 3> circles = {};
  VertexIndex vertex = {};
};

/// Called once per event. What it throws passes through `compute`.
using Observer = std::function<void(const TraceEvent&)>;

}  // namespace circle_voronoi
