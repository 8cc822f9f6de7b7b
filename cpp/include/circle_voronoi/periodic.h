// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/finder.h"
#include "circle_voronoi/index.h"
#include "circle_voronoi/point.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// The two periods of a plane that repeats itself: the sides of a box whose opposite sides are glued together. The box
/// is any parallelogram. A sheared box (Lees and Edwards) has an oblique period. The periods may have any order and
/// orientation.
struct Lattice {
  Vector a = {1, 0};
  Vector b = {0, 1};

  friend bool operator==(const Lattice&, const Lattice&) = default;
};

/// The number of times that each period is added to a circle.
using Shift = std::array<std::int32_t, 2>;

/// A copy of a given circle: the circle moved by shift[0] a + shift[1] b.
struct CircleImage {
  CircleIndex circle = {};
  Shift shift = {};

  friend bool operator==(const CircleImage&, const CircleImage&) = default;
};

/// The Voronoi diagram of circles that repeat with the periods of a lattice.
///
/// `diagram` is the certified diagram of the given circles and of the images that decide their cells. The given circles
/// come first: circle i of `diagram` is given circle i. So the functions that take a diagram and a circle (cells.h,
/// curve.h, hull.h) also serve here, for i < circleCount. The other cells belong to images and may lack neighbors.
struct PeriodicDiagram {
  Diagram diagram;
  /// The number of given circles.
  CircleIndex circleCount = 0;
  /// The periods, rounded (computePeriodic).
  Lattice lattice;
  /// For each circle of `diagram` the given circle of which it is an image.
  std::vector<CircleIndex> circleOf;
  /// For each circle of `diagram` its shift from the given circle. It is {0, 0} for i < circleCount, unless
  /// computePeriodic had to move the given circles.
  std::vector<Shift> shiftOf;

  /// Returns circle `other` of `diagram` as circle `circle` sees it: with a shift that is relative to `circle`.
  /// Precondition: the two are at most a few periods apart, as neighbors are.
  [[nodiscard]] CircleImage imageFrom(CircleIndex circle, CircleIndex other) const {
    const Shift& from = shiftOf[static_cast<std::size_t>(circle)];
    const Shift& to = shiftOf[static_cast<std::size_t>(other)];
    return {circleOf[static_cast<std::size_t>(other)], {to[0] - from[0], to[1] - from[1]}};
  }
};

/// Returns the neighbors of a given circle, in the order of its sides: the images across them. A circle may be its own
/// neighbor, with a shift that is not zero. An image recurs if the two cells share several edges.
[[nodiscard]] std::vector<CircleImage> neighbors(const PeriodicDiagram& periodic, CircleIndex circle);

/// Finds the nearest image of a circle, for any point of the plane.
class PeriodicFinder {
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
  double gap = 0;     ///< |c - c'| - r - r'; negative if the circles overlap
};

/// The table of a packing.
struct ContactTable {
  /// The contacts of each visible circle, one circle after the other, in the order of its sides. Each pair of circles
  /// occurs twice, once from each side.
  std::vector<Contact> contacts;
  std::vector<double> areas;  ///< of each circle's cell; 0 if it is hidden
  /// For each circle the share of its cell that it covers, from 0 to 1. For a circle that overlaps none this is its
  /// area divided by that of the cell.
  std::vector<double> packingFractions;
};

/// Measures all borders and cells. Linear time.
[[nodiscard]] ContactTable contactTable(const PeriodicDiagram& periodic);

/// Computes the Voronoi diagram of circles in a plane with two periods. The circles may lie anywhere. They may be
/// larger than the box, hidden, also by images, and their own neighbors.
///
/// Centers and periods are rounded once, to multiples of 2^-50 of the smallest power of two that exceeds every
/// coordinate of the periods and centers, and of 2^-96 like all numbers. So each image lies exactly where the periods
/// say, and ties are settled alike everywhere.
///
/// The circles stay where they are if they lie within one and a half periods of each other, in both directions of the
/// shortest periods of the lattice. Otherwise each circle is moved by whole periods into the parallelogram of the
/// shortest periods at the origin. This also happens if two circles lie at the same place of different boxes. `shiftOf`
/// returns the shift of each circle.
///
/// The diagram of the given circles and their images is certified, and `checkPeriodic` proves that the cells of the
/// given circles fit together across the sides of the box. So they cover the plane, and no further image changes them.
/// If they do not fit together, more images are added.
///
/// Takes about n log n steps for n circles and images. The images lie within a few times the mean distance of circles
/// around the given ones, also across a gap between these and their images. Few circles need images farther away.
///
/// The progress starts anew when images are added. An observer is told of each attempt.
///
/// Errors: see `compute`; badOption if the periods are not finite, exceed kCoordinateLimit, or are zero or parallel up
/// to 2^-40 of the largest coordinate, or if an image is 2^30 periods away; tooManyCircles if the circles and their
/// images exceed kMaxCircles; notCertified if a proof fails.
Result<PeriodicDiagram> computePeriodic(std::span<const Circle> circles, const Lattice& lattice,
                                        const Options& options = {});

/// Checks in linear time that the cells of the given circles fit together across the sides of the box: each border with
/// image s of circle j has a twin, the border of circle j with image -s, each vertex occurs in three cells, Euler's
/// formula V - E + F = 0 holds, and the areas sum to that of the box up to rounding. `computePeriodic` does this with
/// each result. The check knows nothing of how the diagram was made.
///
/// The check uses the areas of the polygons of the vertices, because the area that an arc adds to one cell is missing
/// in the other.
///
/// Errors: badInput if the parts of the diagram do not fit together; notCertified if the cells do not, with a circle.
Result<void> checkPeriodic(const PeriodicDiagram& periodic);

}  // namespace circle_voronoi
