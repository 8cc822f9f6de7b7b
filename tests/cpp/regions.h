// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "circle_voronoi/box.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/periodic_diagram.h"
#include "circle_voronoi/region_queries.h"

namespace circle_voronoi {

// Cells and discs in regions, which tests of many properties use. Precondition: the diagram is certified.

inline Outline outline(const Diagram& diagram, CircleIndex circle, const Region& region) {
  return ClippedDiagram::ofCells(diagram, region, std::array{circle})->outline(circle);
}

inline Outline outlineWithin(const Diagram& diagram, CircleIndex circle, const Region& region, double maxDistance) {
  return ClippedDiagram::ofCells(diagram, region, std::array{circle}, maxDistance)->outline(circle);
}

/// The parts of an edge in a region.
inline std::vector<EdgeCurve> edgePartsIn(const Diagram& diagram, EdgeIndex edge, const Region& region) {
  return ClippedDiagram::from(diagram, region)->edgeParts(edge);
}

inline std::optional<EmptyDisc> largestEmptyDiscCenteredIn(const Diagram& diagram, const Region& region) {
  return ClippedDiagram::from(diagram, region)->largestEmptyDisc();
}

}  // namespace circle_voronoi

namespace circle_voronoi::test {

/// Returns the region of a box that is valid.
inline Region regionOf(const Box& box) { return Region::from(box).value(); }

/// Returns the region of a ring that is valid.
inline Region regionOf(const Region::Ring& ring) { return Region::fromRings(std::array{ring}).value(); }

/// Returns the bounding box of circles. Precondition: there is a circle.
inline Box boundingBoxOf(std::span<const Circle> circles) {
  Box box = {circles[0].x, circles[0].y, circles[0].x, circles[0].y};
  for (const Circle& c : circles) {
    box.minX = std::min(box.minX, c.x - c.r);
    box.minY = std::min(box.minY, c.y - c.r);
    box.maxX = std::max(box.maxX, c.x + c.r);
    box.maxY = std::max(box.maxY, c.y + c.r);
  }
  return box;
}

/// Returns the bounding box, with 1 in place of a width or height of 0.
inline Box validBoxOf(std::span<const Circle> circles) {
  Box box = boundingBoxOf(circles);
  if (box.minX == box.maxX) box.maxX += 1;
  if (box.minY == box.maxY) box.maxY += 1;
  return box;
}

inline double boxArea(const Lattice& lattice) {
  return std::abs(lattice.a.x * lattice.b.y - lattice.a.y * lattice.b.x);
}

}  // namespace circle_voronoi::test
