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
  /// The vectors from the center of each of the three circles to the center of the disc. They are accurate relative to
  /// the circles' mutual distances, however far the circles are from the origin.
  std::array<Vector, 3> toCenter;
};

/// Computes the disc that touches circles a, b, c counter-clockwise in this order. Returns nothing if there is none.
///
/// Relative to the circle o of smallest radius, the center (x, y) and the distance rho = radius + o.r from it lie on
/// two planes and on the cone x^2 + y^2 = rho^2; of the two points the counter-clockwise disc is always the same root.
/// threeTouchDisc(a, b, c) == threeTouchDisc(b, c, a) up to the order of toCenter, bit for bit unless radii are equal.
std::optional<ThreeTouchDisc> threeTouchDisc(const Circle& a, const Circle& b, const Circle& c);

/// Computes the disc of three circles in counter-clockwise order, times `unit`, a power of two. However near the
/// circles come to having no disc, or an infinitely large one, it is right to 36 bits of their distances from each
/// other and from its center. Returns nothing if a number exceeds the largest double. If the circles have no disc, the
/// result is nothing or arbitrary. Its bits depend on the three circles alone: the same circles in another unit that
/// rounds none of them have the same vertex.
std::optional<Vertex> vertexOf(const Circle& a, const Circle& b, const Circle& c, double unit = 1);

/// Returns the result of vertexOf for the case that its first disc is not accurate enough. Double arithmetic computes
/// this first disc, without scaling.
std::optional<Vertex> vertexOfRareDisc(const Circle& a, const Circle& b, const Circle& c, double unit);

/// Returns the center and the radius of a disc, times `unit`; nothing if its error bound is too large for vertexOf.
std::optional<Vertex> vertexAt(const CornerDisc& placed, const exact::Face& circles, double unit);

}  // namespace circle_voronoi
