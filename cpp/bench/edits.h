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

/// Prints the times of insertions, removals and small moves: one by one, in batches, and from an empty diagram. Prints
/// the times of the worst single edits and the memory of an editor. The times of CGAL's Apollonius hierarchy are
/// printed for comparison. Each line has a process of its own.
void printEdits(const EditInput& input, unsigned limitSeconds);

}  // namespace circle_voronoi::bench
