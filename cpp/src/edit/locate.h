// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bucket_grid.h"
#include "edit_state.h"

namespace circle_voronoi {

/// A circle and, if at least two circles are visible, the half-edge from it in whose sector the point lies.
struct Location {
  int slot = kNone;
  int halfEdge = kNone;
};

/// Finds the visible circle that is nearest to a point, up to rounding. It walks from each cell to a neighbor that is
/// nearer, until there is none. The walk leaves a cell across the edge in whose sector the point lies. Cells are
/// star-shaped, and every point beyond the edge in this sector is nearer to the neighbor across.
///
/// A grid of buckets remembers a circle near each place. Buckets only save steps, so they may be outdated. Then a
/// nearby bucket is used.
class Locator {
 public:
  /// Returns the location of a point, or an empty Location if no circle is visible. The walk starts from the nearest of
  /// three circles: `hint`, the circle found last, and the circle in the bucket of the point.
  Location locate(const EditState& state, Point p, int hint = kNone) const;

  /// Remembers a visible circle: as the circle found last, and in its bucket.
  void note(const EditState& state, int slot);

  /// Clears all buckets and creates new ones for the current circles.
  void fill(const EditState& state);

 private:
  BucketGrid starts_;
  int last_ = kNone;
  int filledFor_ = 0;  ///< the number of visible circles at the last `fill`
};

}  // namespace circle_voronoi
