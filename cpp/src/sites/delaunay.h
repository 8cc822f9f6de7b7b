// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "dual.h"
#include "progress_callback.h"
#include "threads.h"
#include "vectors.h"

namespace circle_voronoi {

/// The Delaunay triangulation of any number of points, in any position and order, found in n log n steps. Equal points
/// share one corner. Ties of four co-circular points are broken by coordinates (perturbed_circle.h), so the
/// triangulation does not depend on the order of the points.
struct Delaunay {
  Dual dual;  ///< faces in the order of their smallest corner
  /// For each point, the point that represents it as a corner: the first of all points equal to it.
  std::vector<int> representative;
  /// The number of steps: points compared with a cut, sides of a hull passed, edges made or flipped.
  std::int64_t steps = 0;
};
Delaunay delaunay(std::span<const Point> points, Threads threads = Threads());

/// The edges of the same Delaunay triangulation, each once. `progress` is called with the part done, 0 to 1.
struct DelaunayEdges {
  std::vector<std::array<int, 2>> edges;
  std::vector<int> representative;
};
DelaunayEdges delaunayEdges(std::span<const Point> points, const ProgressCallback& progress = {});

}  // namespace circle_voronoi
