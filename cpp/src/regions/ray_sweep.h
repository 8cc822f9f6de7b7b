// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "circle_voronoi/diagram.h"
#include "circle_voronoi/region.h"
#include "shifted_signs.h"

namespace circle_voronoi {

/// A place in a cell that is a corner of a region or a given point, with the ray from the center of the cell through
/// it.
struct RayPlace {
  Point point;
  std::span<const RegionSideIndex> corners;   ///< the sides of the region that begin here
  std::span<const RegionSideIndex> touching;  ///< the sides that contain the place, but not as a corner
  std::span<const std::int32_t> given;        ///< the given points at the place, by index
  bool goesOn = false;                        ///< whether the ray goes on from here in the region
  /// Whether the ends of rays jump here: the rays on one side of the place do not go on, those on the other side do.
  bool isJump = false;
  RegionSideIndex first = {};  ///< the first side that the ray crosses after the place; kNone if there is none
};

/// Rotates a ray around the center of a cell, and finds which side of a region it meets first after each corner. The
/// region and the given points are moved together (shifted_signs.h), so no ray passes through two places.
class RaySweep {
 public:
  RaySweep(const Region& region, const ShiftedSigns& signs);

  /// Visits the corners of a region in a cell, and given points in it, counter-clockwise. `sides` has all sides with a
  /// part in the cell. Takes O(m log m) steps for m sides and points.
  void run(CircleIndex cell, Point center, std::span<const RegionSideIndex> sides,
           std::span<const RegionSideIndex> corners, std::span<const Point> given,
           const std::function<void(const RayPlace&)>& visit);

 private:
  /// A side as seen from the center: it begins at the end that a ray meets first, counter-clockwise.
  struct Side {
    RegionSideIndex index;
    Point from;
    Point to;
    int centerSign;  ///< the side of its line on which the center lies
    Point first() const { return centerSign > 0 ? from : to; }
    Point last() const { return centerSign > 0 ? to : from; }
  };

  int signOfPlace(const Side& side, Point p) const;
  bool isNearer(const Side& one, const Side& other) const;
  bool isEarlier(Point one, Point other) const;
  void decideRay(RayPlace& place) const;
  RegionSideIndex before(RegionSideIndex side) const;
  RegionSideIndex after(RegionSideIndex side) const;
  Point pointOf(RegionSideIndex side) const { return region_.points()[static_cast<std::size_t>(side)]; }

  const Region& region_;
  const ShiftedSigns& signs_;
  CircleIndex cell_;
  Point center_;
};

}  // namespace circle_voronoi
