// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dual.h"
#include "dual_keeper.h"
#include "face_discs.h"

namespace circle_voronoi {

/// What flips have done.
struct Flips {
  std::int64_t count = 0;
  std::vector<int> wrong;  ///< the faces of the dual that they leave visibly wrong (wrong_faces.h); increasing
};

/// Turns a triangulation into the dual of the Voronoi diagram of its circles by flips: every edge whose end vertices
/// are out of order along their bisector is flipped (after C. L. Lawson, 1977), and a face without a disc loses the
/// edge whose tangent line the opposite circle crosses. Starting from the Delaunay triangulation of the centers this
/// ends in the dual in nearly all cases; nothing guarantees it: where flips go round in circles, as where an edge is as
/// wrong as the one that would take its place, they stop. So the result is to be judged.
///
/// `discs` are all the discs of `dual`, before and after. `watcher` is told of each face that changes, if there is one.
Flips flip(Dual& dual, FaceDiscs& discs, FaceWatcher* watcher = nullptr);

/// The same where only the edges given, by a half-edge each, may be wrong.
Flips flipFrom(Dual& dual, FaceDiscs& discs, std::span<const int> edges, FaceWatcher& watcher);

/// Flips the edges given, of length zero in a right dual, and those of their discs, until all are settled
/// (settle_ties.h).
void flipTies(Dual& dual, FaceDiscs& discs, std::span<const int> ties, FaceWatcher& watcher);

}  // namespace circle_voronoi
