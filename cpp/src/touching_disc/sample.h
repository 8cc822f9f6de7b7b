// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "circle_voronoi/circle.h"
#include "dual.h"
#include "vectors.h"

namespace circle_voronoi {

/// Points on circles, each with the circle it lies on.
struct Samples {
  std::vector<Point> points;
  std::vector<int> circles;
};

/// Dynamic sampling (paper, section 5): on each circle a point towards each neighbour in the Delaunay graph of the
/// centres, and `angular` (N_s) points that divide the angle of each finite face into equal parts. Samples may
/// coincide.
///
/// The circles are taken less the smallest radius: the diagram does not change when a number is added to all radii,
/// and less of them overlaps. `centres` has the centres of `circles` as corners.
Samples sampleDynamically(std::span<const Circle> circles, const Dual& centres, std::span<const int> angular);

/// `count` equally spaced points on each circle (paper, section 4.1), likewise less the smallest radius.
Samples sampleUniformly(std::span<const Circle> circles, int count);

}  // namespace circle_voronoi
