// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "circle_voronoi/point.h"
#include "elementary.h"

namespace circle_voronoi::degrees {

// Points are longitudes (x, from -180 to before 180) and latitudes (y) in degrees.

/// Places this near to a pole or the antimeridian, in degrees along the ground, are on it: a tenth of a micrometer on
/// the Earth.
inline constexpr double kSnap = 1e-12;

inline bool isPole(Point p) { return std::abs(p.y) == 90; }

/// Returns a point with rounding at the antimeridian and the poles removed.
inline Point snapped(Point p) {
  if (90 - std::abs(p.y) <= kSnap) return {0, p.y < 0 ? -90.0 : 90.0};
  if ((180 - std::abs(p.x)) * sineCosineOfDegrees(p.y).cosine <= kSnap) return {-180, p.y};
  return p;
}

/// Returns the difference of longitudes from -180 to 180, on the shorter way.
inline double turn(double from, double to) {
  const double difference = to - from;
  return difference > 180 ? difference - 360 : difference < -180 ? difference + 360 : difference;
}

/// Whether two points are the same place up to rounding.
inline bool isSame(Point p, Point q) {
  const double across = turn(p.x, q.x) * sineCosineOfDegrees(p.y).cosine;
  return std::abs(across) + std::abs(q.y - p.y) <= kSnap;
}

using Ring = std::vector<Point>;
/// The outer ring, counter-clockwise, and holes.
using Polygon = std::vector<Ring>;

/// Whether a ring is the rectangle of all degrees.
bool isWhole(const Ring& ring);

/// Returns the polygons of the region to the left of a closed line on the sphere, cut at the antimeridian: in the
/// rectangle of all degrees, along whose sides they are closed. Without points, the region is the whole sphere.
///
/// Points are `snapped`. Sides run in the direction of the smaller difference of longitudes, and at a pole such that
/// the region is between them.
std::vector<Polygon> polygonsOf(const Ring& line);

}  // namespace circle_voronoi::degrees
