// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "edit_state.h"

namespace circle_voronoi {

/// A circle and, if there are two visible ones or more, the half-edge from it in whose sector the point lies.
struct Place {
  int slot = kNone;
  int halfEdge = kNone;
};

/// Finds the visible circle that is nearest to a point, up to rounding, by a walk from cell to cell: from one to a
/// neighbour that is nearer, until there is none. A cell is left across the edge in whose sector the point lies: cells
/// are star-shaped, and all that lies beyond the edge in this sector is nearer to the neighbour across.
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
  int columnOf(Point p) const;
  int rowOf(Point p) const;
  std::size_t bucketAt(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }
  void put(const Circle& circle, int slot);
  void fillEmptyBuckets();
  int startNear(const EditState& state, Point p) const;

  Point corner_;
  double scale_ = 0;  ///< buckets a unit of length
  int columns_ = 0;
  int rows_ = 0;
  std::vector<int> buckets_;
  int last_ = kNone;
  int filledFor_ = 0;  ///< so many circles
};

}  // namespace circle_voronoi
