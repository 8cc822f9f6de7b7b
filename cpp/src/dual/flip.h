// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dual.h"
#include "dual_keeper.h"
#include "face_discs.h"

namespace circle_voronoi {

/// The result of a series of flips.
struct Flips {
  std::int64_t count = 0;
  std::vector<int> wrong;  ///< the faces of the dual that they leave visibly wrong (wrong_faces.h); increasing
};

/// Turns a triangulation into the dual of the Voronoi diagram of its circles by flips. Flips every edge whose end
/// vertices are out of order along their bisector (after C. L. Lawson, 1977). Where a face has no disc, flips the edge
/// whose tangent line the opposite circle crosses. From the Delaunay triangulation of the centers, the flips end in the
/// dual in nearly all cases, but nothing guarantees this. They stop where they would cycle, for example where an edge
/// is as wrong as the edge that would replace it. Therefore the caller must judge the result.
///
/// `discs` holds the discs of all faces of `dual`, before and after the flips. If `watcher` is given, it is told of
/// each face that changes.
Flips flip(Dual& dual, FaceDiscs& discs, FaceWatcher* watcher = nullptr);

/// Works like `flip`, but expects that only the given edges may be wrong. Each edge is given by one of its half-edges.
Flips flipFrom(Dual& dual, FaceDiscs& discs, std::span<const int> edges, FaceWatcher& watcher);

/// Flips the given edges, which have length zero in a correct dual, and the other such edges of their discs, until all
/// are settled (settle_ties.h).
void flipTies(Dual& dual, FaceDiscs& discs, std::span<const int> ties, FaceWatcher& watcher);

}  // namespace circle_voronoi
