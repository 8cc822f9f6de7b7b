// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "circle_voronoi/circle.h"

namespace circle_voronoi::bench {

struct EditInput {
  std::string family;
  std::vector<Circle> circles;
  std::vector<Circle> supply;  ///< circles to insert, of the same kind
};

/// Prints the times of insertions, removals and small moves: one by one, in batches, and from nothing. Prints the times
/// of the worst single edits and the memory of an editor. CGAL's Apollonius hierarchy stands beside. Each line has a
/// process of its own.
void printEdits(const EditInput& input, unsigned limitSeconds);

}  // namespace circle_voronoi::bench
