// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/vertex.h"
#include "exact.h"
#include "homogeneous_disc.h"
#include "vectors.h"

namespace circle_voronoi {

/// The disc that touches three circles from outside.
struct ThreeTouchDisc {
  Vertex disc;
  /// From the center of each of the three circles to the center of the disc: accurate relative to the three circles'
  /// mutual distances, however far they are from the origin.
  std::array<Vector, 3> toCenter;
};

/// The disc that touches circles a, b, c counter-clockwise in this order, if there is one.
///
/// Relative to the circle o of smallest radius, the center (x, y) and the distance rho = radius + o.r from it lie on
/// two planes and on the cone x^2 + y^2 = rho^2; of the two points the counter-clockwise disc is always the same root.
/// threeTouchDisc(a, b, c) == threeTouchDisc(b, c, a) up to the order of toCenter, bit for bit unless radii are equal.
std::optional<ThreeTouchDisc> threeTouchDisc(const Circle& a, const Circle& b, const Circle& c);

/// The disc of three circles that have one, counter-clockwise, times `unit`, a power of two. However near they come to
/// having none, or to one that is infinitely large, it is right to 36 bits of the circles' distances from each other
/// and from its center. None if a number of it is beyond the doubles. Of circles that have no disc it is none or
/// anything. The bits depend on the three circles alone: the same circles in another unit that rounds none of them have
/// the same vertex.
std::optional<Vertex> vertexOf(const Circle& a, const Circle& b, const Circle& c, double unit = 1);

/// Returns what vertexOf returns, for the case where its first disc is not accurate enough. Double arithmetic computes
/// that disc as for circles that are not near one another.
std::optional<Vertex> vertexOfRareDisc(const Circle& a, const Circle& b, const Circle& c, double unit);

/// The center and the radius of a disc, times `unit`, if its error bound is small enough for that.
std::optional<Vertex> vertexAt(const CornerDisc& placed, const exact::Face& circles, double unit);

}  // namespace circle_voronoi
