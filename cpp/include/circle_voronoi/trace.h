// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string_view>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/diagram.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// What happens.
///
/// In the touching disc method, in order: candidates (paper, sections 4.1 and 5), then the event loop (Algorithms 2
/// and 3). By `resample` all begins anew, `roundBegun` each time.
///
/// Where the dual of the diagram is changed face by face, by flips and by edits: the faces that are there, each as
/// `faceMade`; then of each change its reason, if one can be named, the faces that go and those that come. A face is a
/// vertex of the diagram, or with two circles an unbounded end. The faces that are left are those of the diagram.
enum class TraceKind {
  roundBegun,     ///< all anew, as what follows is counted; `numbers[0]` is its number, from 0
  centersJoined,  ///< an edge of the Delaunay graph of the visible circles' centres
  sampleTaken,    ///< the point `disc`, of radius 0, on circles[0] less the smallest of all radii
  samplesJoined,  ///< an edge of the Delaunay graph of the samples, of which coinciding ones count as their first
  pairFound,      ///< circles[0] and circles[1] get an antipodal disc
  antipodalDiscAccepted,  ///< the disc is empty; its two directed edges follow
  antipodalDiscUsed,      ///< rejected: a footpoint lies on an arc already used for the diagram
  antipodalDiscNotEmpty,  ///< rejected: it meets `circles[2]`
  threeTouchDiscFormed,   ///< put into the queue
  threeTouchDiscStale,    ///< discarded: its directed edges are gone or no longer adjacent
  branchDisc,             ///< a three-touch disc that is empty: `vertex` is made
  directedEdgePlaced,     ///< from circles[0] to circles[1]; `disc` is its disc of R_min
  directedEdgeDeleted,    ///< from circles[0] to circles[1]
  segmentFinished,  ///< the Voronoi segment of the directed edge circles[0] to circles[1]; `disc` is its disc of R_max
  faceMade,         ///< of these circles, counter-clockwise, with the disc that touches them, if they have one
  faceRemoved,
  discNotEmpty,  ///< the disc of a face with the edge of circles[0] and circles[1] meets circles[2], or ties: it goes
  discMissing,   ///< these circles have no disc, though they are a face: the edge of circles[0] and circles[1] goes
  tangentNotClear,  ///< the tangent line of the neighbours circles[0] and circles[1] on the hull meets circles[2]
  hullNotConvex,    ///< circles[0] lies within the tangent line of its neighbours on the hull, which it leaves
  circleInserted,   ///< `disc` is the circle, and circles[0] its id: as in all events of an editor
  circleRemoved,
  circleReplaced,  ///< moved or resized to `disc`
  circleShrunk,    ///< so far, on its way out, to `disc`: there it touches a disc of its neighbours
};

/// A kind's name outside C++; empty past the last one.
std::string_view traceKindName(TraceKind kind);

/// One event. Discs are given in the units of the input, NaN where a face has none; circles are input indices, kNone
/// where there is none.
/// A three-touch disc names its circles in the paper's order, clockwise: directed edges 0 to 1, 1 to 2 (and 2 to 0).
struct TraceEvent {
  TraceKind kind = TraceKind::roundBegun;
  Vertex disc;
  std::array<CircleIndex, 3> circles = {};
  VertexIndex vertex = {};
  /// Counted from 0, kNone where there is none: of `samplesJoined` the two samples; of `directedEdgePlaced`,
  /// `directedEdgeDeleted` and `segmentFinished` the directed edge, as they are placed; of a three-touch disc the two
  /// that form it; of a face its own, which may be that of another when it has gone.
  std::array<std::int32_t, 2> numbers = {kNone, kNone};
};

/// Called once per event. What it throws passes through `compute`.
using Observer = std::function<void(const TraceEvent&)>;

}  // namespace circle_voronoi
