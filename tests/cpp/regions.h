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
#include "circle_voronoi/convex_polygon.h"
#include "circle_voronoi/periodic_diagram.h"
#include "circle_voronoi/region_queries.h"

namespace circle_voronoi {

// Cells and discs in convex polygons, which tests of many properties use. Precondition: the diagram is certified.

inline Region regionIn(const ConvexPolygon& polygon) { return Region::from(polygon).value(); }

inline Outline outline(const Diagram& diagram, CircleIndex circle, const ConvexPolygon& polygon) {
  const Region region = regionIn(polygon);
  return ClippedDiagram::ofCells(diagram, region, std::array{circle})->outline(circle);
}

inline Outline clippedBufferOutline(const Diagram& diagram, CircleIndex circle, const ConvexPolygon& polygon,
                                    double maxDistance) {
  const Region region = regionIn(polygon);
  return ClippedDiagram::ofCells(diagram, region, std::array{circle}, maxDistance)->outline(circle);
}

/// The parts of an edge in a polygon.
inline std::vector<EdgeCurve> edgePartsIn(const Diagram& diagram, EdgeIndex edge, const ConvexPolygon& polygon) {
  const Region region = regionIn(polygon);
  return ClippedDiagram::from(diagram, region)->edgeParts(edge);
}

inline std::optional<EmptyDisc> largestEmptyDiscCenteredIn(const Diagram& diagram, const ConvexPolygon& polygon) {
  const Region region = regionIn(polygon);
  return ClippedDiagram::from(diagram, region)->largestEmptyDisc();
}

inline std::optional<EmptyDisc> largestEmptyDiscInside(const Diagram& diagram, const ConvexPolygon& polygon) {
  return largestEmptyDiscInside(diagram, regionIn(polygon)).value();
}

}  // namespace circle_voronoi

namespace circle_voronoi::test {

/// Returns the region of a box that is valid.
inline ConvexPolygon regionOf(const Box& box) { return ConvexPolygon::from(box).value(); }

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
