// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ring_sweep.h"

namespace circle_voronoi {

/// Returns the rings around the union of polygons, which may overlap, share sides and cross themselves. A point belongs
/// to a polygon if an odd number of its rings contain it. `polygonOfRing` has the polygon of each ring, counted from 0.
/// The result has no rings if the polygons have no area.
///
/// The rings of the result run in either direction. They neither cross nor overlap, touch in single points only, and do
/// not cut the inside of a polygon apart: a point is in the union if an odd number of rings contain it. Points where
/// sides cross are rounded; all other points are points of the polygons, to the bit, unless sides nearly coincide
/// (RegionOptions).
Rings dissolved(const Rings& rings, std::span<const std::int32_t> polygonOfRing);

}  // namespace circle_voronoi
