// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "face_discs.h"

namespace circle_voronoi {

/// Returns the faces at which some edges of a dual are visibly wrong, in increasing order. Each edge is given by one of
/// its half-edges. For each wrong edge (FaceDiscs::flawOf) these are the two faces beside it. If a disc is missing
/// there, they are only the faces without a disc.
std::vector<int> wrongFaces(const FaceDiscs& discs, std::span<const int> edges);

/// Checks all edges of the dual instead of a list. Takes linear time.
std::vector<int> wrongFaces(const FaceDiscs& discs);

}  // namespace circle_voronoi
