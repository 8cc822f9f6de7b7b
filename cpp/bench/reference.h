// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "circle_voronoi/circle.h"

namespace circle_voronoi::reference {

/// CGAL's constructions for the same circles. Each returns a number of vertices, so that nothing is optimized away.

/// Delaunay_triangulation_2 of the centers.
[[gnu::visibility("default")]] std::size_t delaunay(std::span<const Circle> circles);

/// Apollonius_graph_hierarchy_2 with filtered traits: the fast variant of CGAL.
[[gnu::visibility("default")]] std::size_t apolloniusHierarchy(std::span<const Circle> circles);

/// Apollonius_graph_2 with an exact number type throughout.
[[gnu::visibility("default")]] std::size_t apolloniusExact(std::span<const Circle> circles);

/// Inserts circles into CGAL's hierarchy of other circles and removes each one before the next. Appends the seconds of
/// each insertion and removal. A circle that is hidden, or hides others, is not removed.
[[gnu::visibility("default")]] void apolloniusEdits(std::span<const Circle> circles, std::span<const Circle> inserted,
                                                    std::vector<double>& inserts, std::vector<double>& removals);

}  // namespace circle_voronoi::reference
