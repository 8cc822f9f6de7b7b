// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "dual.h"
#include "weighted_point.h"

namespace circle_voronoi {

/// The dual of a power diagram, a regular triangulation, and the sites that are none of its corners.
struct RegularTriangulation {
  Dual dual;
  std::vector<int> hidden;  ///< in increasing order
};

/// Computes the regular triangulation of sites in different places, one after the other: a site takes the faces below
/// whose planes it is lifted (H. Edelsbrunner, N. R. Shah, "Incremental topological flipping works for regular
/// triangulations", 1996; here all of them at once, after A. Bowyer, 1981). All signs are exact.
///
/// A site is a corner if and only if its cell has an interior, and the faces of sites that are lifted into one plane
/// are those of `settleTies`. So the result depends neither on the order of the sites nor on where they are. Takes n
/// log n steps for most sites in spatial order, of which it inserts more and more in each round.
RegularTriangulation regularTriangulation(std::span<const WeightedPoint> sites);

}  // namespace circle_voronoi
