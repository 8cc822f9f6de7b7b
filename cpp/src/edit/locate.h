// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bucket_grid.h"
#include "edit_state.h"

namespace circle_voronoi {

/// A circle and, if there are two visible ones or more, the half-edge from it in whose sector the point lies.
struct Place {
  int slot = kNone;
  int halfEdge = kNone;
};

/// Finds the visible circle that is nearest to a point, up to rounding, by a walk from cell to cell: from one to a
/// neighbor that is nearer, until there is none. A cell is left across the edge in whose sector the point lies: cells
/// are star-shaped, and all that lies beyond the edge in this sector is nearer to the neighbor across.
///
/// A grid of buckets remembers a circle near each place; they may be outdated, as they only save steps, and then one
/// beside is asked.
class Locator {
 public:
  /// Nothing if no circle is visible. The walk starts from what is nearest of `hint`, what was found last, and the
  /// bucket of the point.
  Place locate(const EditState& state, Point p, int hint = kNone) const;

  /// Remembers that a visible circle is there.
  void note(const EditState& state, int slot);

  /// Forgets all, and makes buckets anew for the circles there are.
  void fill(const EditState& state);

 private:
  BucketGrid starts_;
  int last_ = kNone;
  int filledFor_ = 0;  ///< so many circles
};

}  // namespace circle_voronoi
