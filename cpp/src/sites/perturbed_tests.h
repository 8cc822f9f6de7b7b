// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "vectors.h"

namespace circle_voronoi {

/// The tests of a Delaunay triangulation, exact and without ties: a point on a circle counts as inside or outside by
/// the coordinates of the four points alone, as if each were lifted off the paraboloid by an amount that is infinitely
/// larger than that of every point before it in lexicographic order (O. Devillers, M. Teillaud, "Perturbations for
/// Delaunay and weighted Delaunay 3D triangulations", 2011).
///
/// For the last stages: where a filter has decided already, these need not be called.
class PerturbedTests {
 public:
  /// `points` must outlive the tests.
  explicit PerturbedTests(std::span<const Point> points) : points_(points) {}

  /// 1 if a, b, c are counter-clockwise, -1 if clockwise, 0 if collinear.
  int orientation(Point a, Point b, Point c);

  /// Whether d lies inside the circle through a, b, c, which are counter-clockwise. The four are distinct.
  bool isInCircle(Point a, Point b, Point c, Point d);

 private:
  double unit();

  std::span<const Point> points_;
  double unit_ = -1;  ///< a power of two of which all coordinates are multiples; negative if not looked for yet
};

}  // namespace circle_voronoi
