// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string_view>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/index.h"
#include "circle_voronoi/vertex.h"

namespace circle_voronoi {

/// The kinds of events.
///
/// The touching disc method first reports the candidates (paper, sections 4.1 and 5), then the event loop (Algorithms 2
/// and 3). With `resample` everything may start anew; each start is a `roundBegun`.
///
/// Flips and edits change the dual face by face. They first report all faces as `faceMade`. For each change they then
/// report its reason, if it has one, the removed faces and the new ones. A face is a vertex of the diagram, or with two
/// circles an unbounded end. The faces that remain at the end are the faces of the diagram's dual.
enum class TraceKind {
  roundBegun,     ///< everything starts anew, and so does the numbering; `numbers[0]` is the round, from 0
  centersJoined,  ///< an edge of the Delaunay graph of the visible circles' centers
  sampleTaken,    ///< the point `disc`, of radius 0, on circles[0] shrunk by the smallest of all radii
  samplesJoined,  ///< an edge of the Delaunay graph of the samples; of coinciding samples the first stands for all
  pairFound,      ///< circles[0] and circles[1] get an antipodal disc
  antipodalDiscAccepted,  ///< the disc is empty; its two directed edges follow
  antipodalDiscUsed,      ///< rejected: a footpoint lies on an arc that the diagram already uses
  antipodalDiscNotEmpty,  ///< rejected: it overlaps `circles[2]`
  threeTouchDiscFormed,   ///< put into the queue
  threeTouchDiscStale,    ///< discarded: its directed edges are gone or no longer adjacent
  branchDisc,             ///< a three-touch disc that is empty: `vertex` is made
  directedEdgePlaced,     ///< from circles[0] to circles[1]; `disc` is its disc of R_min
  directedEdgeDeleted,    ///< from circles[0] to circles[1]
  segmentFinished,  ///< the Voronoi segment of the directed edge circles[0] to circles[1]; `disc` is its disc of R_max
  faceMade,         ///< a face with these circles, counter-clockwise, and the disc that touches them, if there is one
  faceRemoved,
  discNotEmpty,     ///< the edge of circles[0] and circles[1] is flipped: circles[2] overlaps or touches a disc there
  discMissing,      ///< the edge of circles[0] and circles[1] is flipped: these circles are a face, but have no disc
  tangentNotClear,  ///< the tangent line of the neighbors circles[0] and circles[1] on the hull meets circles[2]
  hullNotConvex,    ///< circles[0] leaves the hull: it lies within the tangent line of its neighbors
  circleInserted,   ///< an editor inserts the circle `disc`; its id is circles[0]
  circleRemoved,    ///< an editor removes the circle `disc`; its id is circles[0]
  circleReplaced,   ///< an editor moves or resizes circles[0] to `disc`
  circleShrunk,     ///< on its way out, circles[0] shrinks to `disc`, where it touches a disc of its neighbors
};

/// Returns the name of a kind, as in the enumeration and in JavaScript. Past the last kind the name is empty.
[[nodiscard]] CIRCLE_VORONOI_API std::string_view traceKindName(TraceKind kind);

/// One event. Discs are in the units of the input; they are NaN for a face without a disc. Circles are indices of the
/// input, or ids in an editor; kNone where there is none. A three-touch disc names its circles in the paper's order,
/// clockwise: its directed edges run from 0 to 1, from 1 to 2, and from 2 to 0.
struct TraceEvent {
  TraceKind kind = TraceKind::roundBegun;
  Vertex disc;
  std::array<CircleIndex, 3> circles = {};
  VertexIndex vertex = {};
  /// Numbers counted from 0, kNone where there is none. For `samplesJoined` the two samples. For `directedEdgePlaced`,
  /// `directedEdgeDeleted` and `segmentFinished` the directed edge, in the order of placement. For a three-touch disc
  /// the two directed edges that form it. For a face its number, which another face may reuse once it has gone.
  std::array<std::int32_t, 2> numbers = {kNone, kNone};
};

/// A callback for each event. Its exceptions pass through `compute`. It may call any function of the library, except
/// that an editor refuses edits by its own observer (DiagramEditor::observe).
using Observer = std::function<void(const TraceEvent&)>;

}  // namespace circle_voronoi
