// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/index.h"
#include "circle_voronoi/point.h"

namespace circle_voronoi {

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

/// Checks in linear time that the cells of the given circles fit together across the sides of the box: each border with
/// image s of circle j has a twin, the border of circle j with image -s, each vertex occurs in three cells, Euler's
/// formula V - E + F = 0 holds, and the areas sum to that of the box up to rounding. `computePeriodic` does this with
/// each result. The check knows nothing of how the diagram was made.
///
/// The check uses the areas of the polygons of the vertices, because the area that an arc adds to one cell is missing
/// in the other.
///
/// Errors: badInput if the parts of the diagram do not fit together; notCertified if the cells do not, with a circle.
CIRCLE_VORONOI_API Result<void> checkPeriodic(const PeriodicDiagram& periodic);

}  // namespace circle_voronoi
