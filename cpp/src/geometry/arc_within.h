// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "circle_voronoi/curve.h"
#include "circle_voronoi/diagram.h"
#include "distance_signs.h"

namespace circle_voronoi {

/// An end of a part of an edge: a vertex, a crossing with a side of a region, or infinity.
struct ArcEnd {
  VertexIndex vertex = {};
  std::optional<SideCrossing> crossing = {};
};

/// The part of an arc of an edge within a distance of its circles.
struct ArcWithin {
  EdgeCurve curve;
  bool isCutFrom = false;  ///< whether it begins where the edge meets the rims of both cells
  bool isCutTo = false;

  /// Returns whether cutting has left a point.
  bool isPoint() const { return (isCutFrom || isCutTo) && curve.start == curve.end; }
};

/// Returns the part of an arc of an edge within the distance, in the direction of the edge: nothing if there is none.
/// `curve` is the arc, and `start` and `end` are its ends. Both cells of the edge get the same bits.
std::optional<ArcWithin> arcWithin(const DistanceSigns& signs, const Edge& edge, const EdgeCurve& curve,
                                   const ArcEnd& start, const ArcEnd& end);

}  // namespace circle_voronoi
