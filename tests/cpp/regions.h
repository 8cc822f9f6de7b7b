// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/convex_polygon.h"
#include "circle_voronoi/periodic.h"

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
