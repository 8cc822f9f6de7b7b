// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "face_discs.h"

namespace circle_voronoi {

/// The faces at which some edges of a dual, given by a half-edge each, are visibly wrong: those beside an edge that is
/// (FaceDiscs::flawOf), or the one of them that has no disc. Increasing.
std::vector<int> wrongFaces(const FaceDiscs& discs, std::span<const int> edges);

/// The same of all edges; linear time.
std::vector<int> wrongFaces(const FaceDiscs& discs);

}  // namespace circle_voronoi
