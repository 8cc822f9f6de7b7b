// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "bucket_grid.h"
#include "edit_state.h"

namespace circle_voronoi {

/// A circle and, if at least two circles are visible, the half-edge from it in whose sector the point lies.
struct Location {
  int slot = kNone;
  int halfEdge = kNone;
  int steps = 0;  ///< the number of half-edges passed around cells with many
};

/// Finds the visible circle that is nearest to a point, up to rounding. It walks from each cell to a neighbor that is
/// nearer, until there is none. The walk leaves a cell across the edge in whose sector the point lies. Cells are
/// star-shaped, and every point beyond the edge in this sector is nearer to the neighbor across.
///
/// A grid of buckets remembers a circle near each place, and lists remember the half-edges around circles with many
/// neighbors, for bisection. Buckets and lists only save steps, so they may be outdated. Then a nearby bucket or
/// half-edge is used. Once the walks have passed as many half-edges as there are, both are made anew. So n edits beside
/// one circle take about n log n steps, unless nearly all of them are in one place of its border.
class Locator {
 public:
  /// Returns the location of a point, or an empty Location if no circle is visible. The walk starts from the nearest of
  /// three circles: `hint`, the circle found last, and the circle in the bucket of the point.
  Location locate(const EditState& state, Point p, int hint = kNone) const;

  /// Adds the steps of a location.
  void countSteps(const Location& location) { steps_ += location.steps; }

  /// Remembers a visible circle: as the circle found last, and in its bucket.
  void note(const EditState& state, int slot);

  /// Makes all buckets and lists anew for the current circles.
  void fill(const EditState& state);

 private:
  Location sectorOf(const EditState& state, int h, Point p) const;
  int listedToward(const EditState& state, int slot, Vector ray) const;
  void listSpokes(const EditState& state);

  BucketGrid starts_;
  std::unordered_map<int, std::vector<int>> spokes_;  ///< of circles with many, counter-clockwise
  std::int64_t steps_ = 0;                            ///< since the last `fill`
  int last_ = kNone;
  int filledFor_ = 0;  ///< the number of visible circles at the last `fill`
};

}  // namespace circle_voronoi
