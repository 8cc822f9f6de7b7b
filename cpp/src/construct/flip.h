// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "circle_voronoi/circle.h"
#include "dual.h"
#include "predicates.h"

namespace circle_voronoi {

/// Turns a triangulation into the dual of the Voronoi diagram of `circles` by flips: every edge whose end vertices are
/// out of order along their bisector is flipped (after C. L. Lawson, 1977), and a face without a disc loses the edge
/// whose tangent line the opposite circle crosses. Starting from the Delaunay triangulation of the centres this ends in
/// the dual in nearly all cases; nothing guarantees it, so the result is to be judged.
///
/// Returns the number of flips.
std::int64_t flip(std::span<const Circle> circles, Dual& dual, Predicates& predicates);

}  // namespace circle_voronoi
