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
/// threeTouchDisc(a, b, c) == threeTouchDisc(b, c, a) up to the order of toCenter, bit for bit.
std::optional<ThreeTouchDisc> threeTouchDisc(const Circle& a, const Circle& b, const Circle& c);

/// A bound on the error of a vertex, as a share of the sum of the coordinates' differences between it and its circles.
inline constexpr double kVertexRounding = 0x1p-34;

/// Computes the disc of three circles in counter-clockwise order. However near the circles come to having no disc, or
/// an infinitely large one, it is right to 36 bits of their distances from each other and from its center. If the
/// circles have no disc, the result is nothing or arbitrary. Its bits depend on the three circles alone, not on which
/// of them comes first.
///
/// The center lies within 2^876 of the circles. With the letters of exact.cpp, its distance from one of them is 1 / (2
/// t), and t |D|^2 is some p + q root whose norm is |D|^2 <N, N>. As N is a product of two differences, <N, N> is an
/// integer in units of 2^-384, so that t is at least 2^-384 / |p - q root|, and |p - q root| is at most 3 |N| |D| < 3
/// 2^(196 + 295). Where p and q do not cancel, the disc is smaller.
std::optional<Vertex> vertexOf(const Circle& a, const Circle& b, const Circle& c);

/// Returns the result of vertexOf for the case that its first disc, that of discOf, is not accurate enough.
std::optional<Vertex> refinedVertexOf(const Circle& a, const Circle& b, const Circle& c);

/// Returns the center and the radius of a disc; nothing if its error bound is too large for vertexOf.
std::optional<Vertex> vertexAt(const CornerDisc& placed, const exact::Face& circles);

}  // namespace circle_voronoi
