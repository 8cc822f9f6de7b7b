// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/finder.h"
#include "circle_voronoi/index.h"
#include "circle_voronoi/periodic_diagram.h"
#include "circle_voronoi/point.h"

namespace circle_voronoi {

/// Returns the neighbors of a given circle, in the order of its sides: the images across them. A circle may be its own
/// neighbor, with a shift that is not zero. An image recurs if the two cells share several edges.
[[nodiscard]] CIRCLE_VORONOI_API std::vector<CircleImage> neighbors(const PeriodicDiagram& periodic,
                                                                    CircleIndex circle);

/// Finds the nearest image of a circle, for any point of the plane.
class CIRCLE_VORONOI_API PeriodicFinder {
 public:
  /// Takes linear time. The diagram must outlive the finder.
  explicit PeriodicFinder(const PeriodicDiagram& periodic);
  explicit PeriodicFinder(const PeriodicDiagram&& periodic) = delete;

  /// Returns the circle nearest to p, and the shift of the image that is; circle kNone if there are no circles. Several
  /// may be equally near up to rounding. Errors: badInput if p is not finite, or the shift is 2^30 periods or more.
  Result<CircleImage> find(Point p) const;

 private:
  const PeriodicDiagram* periodic_;
  Finder finder_;
  Lattice shortest_;
  std::array<Vector, 2> ofGiven_;  ///< how many given periods each of the shortest periods has
};

/// Two circles with a common border.
struct Contact {
  CircleIndex circle = {};
  CircleImage neighbor;
  double length = 0;  ///< of the border; the sum if the two cells share several edges
  /// |c - c'| - r - r'; negative if the circles overlap. Where the weights of a power diagram are given, r is the root
  /// of the weight, with its sign.
  double gap = 0;
};

/// The table of a packing.
struct ContactTable {
  /// The contacts of each visible circle, one circle after the other, in the order of its sides. Each pair of circles
  /// occurs twice, once from each side.
  std::vector<Contact> contacts;
  std::vector<double> areas;  ///< of each circle's cell; 0 if it is hidden
  /// For each circle the share of its cell that it covers, from 0 to 1. For a circle that overlaps none this is its
  /// area divided by that of the cell. For one that does, this is only known for Metric::circles, and else NaN.
  std::vector<double> packingFractions;
};

/// Measures all borders and cells. Linear time.
[[nodiscard]] CIRCLE_VORONOI_API ContactTable contactTable(const PeriodicDiagram& periodic);

}  // namespace circle_voronoi
