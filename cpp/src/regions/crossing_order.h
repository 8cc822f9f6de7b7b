// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/diagram.h"
#include "circle_voronoi/region.h"
#include "crossings.h"
#include "shifted_signs.h"

namespace circle_voronoi {

/// The order of the crossings of one edge, exact for the region that is moved by a tiny shift (shifted_signs.h).
class CrossingOrder {
 public:
  CrossingOrder(const Diagram& diagram, const Region& region) : diagram_(diagram), region_(region), signs_(diagram) {}

  /// Returns whether one of two crossings of an edge comes before the other one, in the direction of the edge.
  bool isBefore(const Crossing& p, const Crossing& q) const;

 private:
  ShiftedSigns::Line lineOf(const Crossing& crossing) const;

  const Diagram& diagram_;
  const Region& region_;
  ShiftedSigns signs_;
};

}  // namespace circle_voronoi
