// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "circle_voronoi/circle.h"
#include "dual.h"
#include "predicates.h"

namespace circle_voronoi {

struct Inserted {
  Dual dual;                   ///< the circles that are not hidden, in no particular order
  std::vector<char> isHidden;  ///< whether a circle lies in another one
  std::int64_t flips = 0;
};

/// The dual of the Voronoi diagram of circles in spatial order, no two of them with the same center, by inserting one
/// after the other in random rounds: of any circles n log n steps are expected (K. Mehlhorn, S. Meiser, C. O'Dunlaing,
/// "On the construction of abstract Voronoi diagrams", 1991; K. L. Clarkson, P. W. Shor, "Applications of random
/// sampling in computational geometry, II", 1989). A new circle cuts an edge of the cell that its center lies in, and
/// flips take the edges away that its cell has all of. A circle that is inside another gets no cell, or loses it.
///
/// The result must be judged. Returns nothing if a hidden circle could not be removed.
std::optional<Inserted> insertAll(std::span<const Circle> circles, Predicates& predicates);

}  // namespace circle_voronoi
