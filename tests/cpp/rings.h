// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "circle_voronoi/region.h"

namespace circle_voronoi::test {

/// Returns the region of rings that are valid.
inline Region regionFrom(const std::vector<Region::Ring>& rings) { return Region::fromRings(rings).value(); }

/// Returns the signed area of a closed ring of points or of pairs of numbers; counter-clockwise is positive.
template <class Ring>
double areaOf(const Ring& ring) {
  const auto pointAt = [&](std::size_t k) -> Point {
    if constexpr (requires { ring[k].x; }) {
      return ring[k];
    } else {
      return {ring[k][0], ring[k][1]};
    }
  };
  double twice = 0;
  for (std::size_t k = 1; k < ring.size(); ++k) {
    const Point o = pointAt(0);
    const Point p = pointAt(k - 1);
    const Point q = pointAt(k);
    twice += (p.x - o.x) * (q.y - o.y) - (q.x - o.x) * (p.y - o.y);
  }
  return twice / 2;
}

/// Returns whether a point is in a ring, by a ray to the right. For points on the ring the result is arbitrary.
inline bool isInRing(const Region::Ring& ring, Point p) {
  bool isIn = false;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point a = ring[k];
    const Point b = ring[(k + 1) % ring.size()];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) isIn = !isIn;
  }
  return isIn;
}

/// Returns the polygons of a region, as a region is made from.
inline std::vector<std::vector<Region::Ring>> polygonsOf(const Region& region) {
  std::vector<std::vector<Region::Ring>> polygons(region.polygonCount());
  const auto rings = region.ringOffsets();
  for (std::size_t r = 0; r < region.ringCount(); ++r) {
    const std::int32_t polygon = region.polygonOf(static_cast<std::int32_t>(r));
    polygons[static_cast<std::size_t>(polygon)].emplace_back(region.points().begin() + rings[r],
                                                             region.points().begin() + rings[r + 1]);
  }
  return polygons;
}

/// The two ends of a side.
using Side = std::array<Point, 2>;

/// Returns the sides of all rings of a region.
inline std::vector<Side> sidesOf(const Region& region) {
  std::vector<Side> sides;
  const auto points = region.points();
  const auto rings = region.ringOffsets();
  for (std::size_t r = 0; r + 1 < rings.size(); ++r) {
    for (std::int32_t k = rings[r]; k < rings[r + 1]; ++k) {
      const std::int32_t next = k + 1 == rings[r + 1] ? rings[r] : k + 1;
      sides.push_back({points[static_cast<std::size_t>(k)], points[static_cast<std::size_t>(next)]});
    }
  }
  return sides;
}

inline double distanceToSide(Point p, const Side& side) {
  const auto& [a, b] = side;
  const double x = b.x - a.x;
  const double y = b.y - a.y;
  const double square = x * x + y * y;
  const double t = square == 0 ? 0 : std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / square, 0.0, 1.0);
  return std::hypot(p.x - a.x - t * x, p.y - a.y - t * y);
}

/// Returns the distance of a point from the nearest side of a ring.
inline double distanceToRing(const Region::Ring& ring, Point p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < ring.size(); ++k) {
    least = std::min(least, distanceToSide(p, {ring[k], ring[(k + 1) % ring.size()]}));
  }
  return least;
}

}  // namespace circle_voronoi::test
