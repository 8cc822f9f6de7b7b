// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "dual.h"
#include "face_discs.h"

namespace circle_voronoi {

/// Turns a triangulation into the dual of the Voronoi diagram of its circles by flips: every edge whose end vertices
/// are out of order along their bisector is flipped (after C. L. Lawson, 1977), and a face without a disc loses the
/// edge whose tangent line the opposite circle crosses. Starting from the Delaunay triangulation of the centres this
/// ends in the dual in nearly all cases; nothing guarantees it, so the result is to be judged.
///
/// `discs` are all the discs of `dual`, before and after. Returns the number of flips.
std::int64_t flip(Dual& dual, FaceDiscs& discs);

}  // namespace circle_voronoi
