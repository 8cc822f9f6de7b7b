// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/export.h"
#include "circle_voronoi/periodic_diagram.h"

namespace circle_voronoi {

/// Returns the vector that a shift stands for.
inline Vector offsetOf(const Lattice& lattice, const Shift& shift) {
  const auto& [a, b] = lattice;
  return {shift[0] * a.x + shift[1] * b.x, shift[0] * a.y + shift[1] * b.y};
}

/// Returns the smallest box with the parallelogram of the periods at the origin.
Box boxOf(const Lattice& lattice);

/// Returns the options without attributes, with a box around all circles of the diagram and the cells of the given
/// ones, which it does not cut, and with a tolerance that suits the periods.
/// Errors: badOption if a box, a region or a maximum distance is given; badInput if the numbers of attributes and
/// circles differ.
Result<ExportOptions> periodicOptions(const PeriodicDiagram& periodic, const ExportOptions& options);

/// Returns attributes for all images: the attributes of the given circles, which come first, and none for the others.
CircleAttributes imageAttributes(const PeriodicDiagram& periodic, const CircleAttributes* attributes);

}  // namespace circle_voronoi
