// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "circle_voronoi/circle.h"
#include "dual.h"
#include "progress_callback.h"
#include "vectors.h"

namespace circle_voronoi {

/// Points on circles, each with the circle it lies on.
struct Samples {
  std::vector<Point> points;
  std::vector<int> circles;
};

/// The most samples: their Delaunay triangulation has six half-edges for each, with 32-bit indices.
inline constexpr std::int64_t kMaxSamplePoints = std::numeric_limits<std::int32_t>::max() / 6;

/// Dynamic sampling (paper, section 5): on each circle a point towards each neighbor in the Delaunay graph of the
/// centers, and `angular` (N_s) points that divide the angle of each finite face into equal parts. Samples may
/// coincide.
///
/// The smallest radius is subtracted from all radii first. This does not change the diagram, and the circles overlap
/// less. `centers` has the centers of `circles` as corners.
///
/// Refuses (guarded.h) more than kMaxSamplePoints, tooManyCircles. Reports the finished part to `progress` from time to
/// time.
Samples sampleDynamically(std::span<const Circle> circles, const Dual& centers, std::span<const int> angular,
                          const ProgressCallback& progress = {});

/// Returns `count` equally spaced points on each circle (paper, section 4.1). Subtracts the smallest radius, refuses
/// too many points and reports progress as sampleDynamically does.
Samples sampleUniformly(std::span<const Circle> circles, int count, const ProgressCallback& progress = {});

}  // namespace circle_voronoi
