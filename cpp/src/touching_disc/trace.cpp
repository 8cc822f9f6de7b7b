// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/trace.h"

namespace circle_voronoi {

std::string_view traceKindName(TraceKind kind) {
  switch (kind) {
    case TraceKind::roundBegun:
      return "roundBegun";
    case TraceKind::centersJoined:
      return "centersJoined";
    case TraceKind::sampleTaken:
      return "sampleTaken";
    case TraceKind::samplesJoined:
      return "samplesJoined";
    case TraceKind::pairFound:
      return "pairFound";
    case TraceKind::antipodalDiscAccepted:
      return "antipodalDiscAccepted";
    case TraceKind::antipodalDiscUsed:
      return "antipodalDiscUsed";
    case TraceKind::antipodalDiscNotEmpty:
      return "antipodalDiscNotEmpty";
    case TraceKind::threeTouchDiscFormed:
      return "threeTouchDiscFormed";
    case TraceKind::threeTouchDiscStale:
      return "threeTouchDiscStale";
    case TraceKind::branchDisc:
      return "branchDisc";
    case TraceKind::directedEdgePlaced:
      return "directedEdgePlaced";
    case TraceKind::directedEdgeDeleted:
      return "directedEdgeDeleted";
    case TraceKind::segmentFinished:
      return "segmentFinished";
    case TraceKind::faceMade:
      return "faceMade";
    case TraceKind::faceRemoved:
      return "faceRemoved";
    case TraceKind::discNotEmpty:
      return "discNotEmpty";
    case TraceKind::discMissing:
      return "discMissing";
    case TraceKind::tangentNotClear:
      return "tangentNotClear";
    case TraceKind::hullNotConvex:
      return "hullNotConvex";
    case TraceKind::circleInserted:
      return "circleInserted";
    case TraceKind::circleRemoved:
      return "circleRemoved";
    case TraceKind::circleReplaced:
      return "circleReplaced";
    case TraceKind::circleShrunk:
      return "circleShrunk";
  }
  return "";
}

}  // namespace circle_voronoi
