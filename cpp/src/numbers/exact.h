// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/point.h"
#include "circle_voronoi/vertex.h"

namespace circle_voronoi::exact {

/// The signs that the certificate rests on, computed in integer arithmetic from the circles' bits: never wrong, never
/// rounded. Circles are passed by pointer; a null pointer is the point at infinity.
///
/// Laws (laws_test.cpp): a face may begin with any of its corners, unless the point at infinity has to be the last one.
///   crossSign(f, g, o) == -crossSign(g, f, o).
///   overlapSign(f, d, o) == overlapSign(f, d, p) for corners o and p of f.
///   touchSign((a, b, c), d, o) is the same for all orders of the four circles. overlapSign(f, d, o) is 0 only if
///   touchSign(f, d, o) is.
///   contains(a, b) && contains(b, a) only if a == b.
///   touchesBetween(a, b, c) == touchesBetween(b, a, c).
/// Moving all circles, multiplying all numbers by a power of two, adding a number to all radii, and turning the plane
/// by a right angle change no sign but that of a direction, as long as nothing is rounded. A reflection of the plane
/// exchanges two corners of each face and both circles of a tangent line: crossSign changes its sign, the others do
/// not.
///
/// A face is three circles in counter-clockwise order around their three-touch disc. With the point at infinity it is
/// two circles and their outer tangent line: (a, b, null) has the line to the left of a -> b. No circle of a face hides
/// another.
using Face = std::array<const Circle*, 3>;

/// Returns the other two corners of a face, in the order of the face after `from`.
inline std::array<const Circle*, 2> othersOf(const Face& face, const Circle* from) {
  const auto at = static_cast<std::size_t>(std::find(face.begin(), face.end(), from) - face.begin());
  return {face[(at + 1) % 3], face[(at + 2) % 3]};
}

/// Returns the smallest circle of a face without the point at infinity; of several, the first.
inline const Circle* smallestOf(const Face& face) {
  const Circle* smallest = face[0]->r <= face[1]->r ? face[0] : face[1];
  return face[2]->r < smallest->r ? face[2] : smallest;
}

/// A direction that no drawing is likely to be aligned with, so that ties are rare.
inline constexpr int kAxisX = 1009;
inline constexpr int kAxisY = 613;

/// Returns whether the face has a disc: radius + r >= 0 for its smallest circle. Always true for a face at infinity.
bool hasDisc(const Face& face);

/// Computes the disc of a face without the point at infinity. Each number is right to 48 bits of itself. Where it
/// cancels against the smallest circle's number, it is right to 48 bits of the distance between the centers of that
/// circle and the disc. Returns nothing if the face has no disc.
std::optional<Vertex> disc(const Face& face);

/// A disc as a homogeneous point (v : w) relative to the center of its smallest circle. The disc's center
/// lies |v| / w from there, with |v| about 1.
struct DiscPoint {
  Vector v;
  double w = 0;
};

/// Computes the disc of a face without the point at infinity. Components of v are right within 2^-46, and w is right
/// within 2^-46 of itself. Returns nothing if the face has no disc or w exceeds the largest double.
std::optional<DiscPoint> discPoint(const Face& face);

/// Returns the sign of the direction from circle `from`, a corner of the face, to the center of the disc: along
/// (kAxisX, kAxisY) if `axis` is 0, or along this axis turned by +90 degrees if it is 1. For a face at infinity the
/// direction is the normal of the tangent line.
/// Precondition: hasDisc(face).
int directionSign(const Face& face, const Circle& from, int axis);

/// Returns the sign of the cross product of the directions to the discs of two faces, seen from circle `from`.
/// Precondition: both faces have a disc, `from` as a corner, and a second corner in common.
int crossSign(const Face& first, const Face& second, const Circle& from);

/// Returns 1 if `other`, a circle or the point at infinity, overlaps the disc of a face, 0 if it touches the disc, -1
/// if it is clear of the disc. `from` is a corner of the face.
int overlapSign(const Face& face, const Circle* other, const Circle& from);

/// Returns the sign that decides a near tie (refined.h). It is 0 if one disc touches `other`, which may be the point at
/// infinity, and the circles of the face. `from` is a corner of the face.
int touchSign(const Face& face, const Circle* other, const Circle& from);

/// Returns whether `outer` contains `inner`.
bool contains(const Circle& outer, const Circle& inner);

/// Returns the normal of the tangent line of the face at infinity (a, b, null), scaled to a length of about 1 at most.
/// Each component is right within 2^-48. Returns nothing if one circle contains the other.
std::optional<Vector> tangentNormal(const Circle& a, const Circle& b);

/// Returns 1 if circle c crosses the tangent line of the face at infinity (a, b, null), 0 if it touches the line, -1 if
/// it is clear of the line.
int tangentSide(const Circle& a, const Circle& b, const Circle& c);

/// Returns whether c touches a common tangent line of circles a and b between the points where a and b touch it. All
/// three touch the line from the same side.
bool touchesBetween(const Circle& a, const Circle& b, const Circle& c);

/// Returns 1 if points a, b, c are counter-clockwise, -1 if they are clockwise, 0 if they are collinear.
int orientation(Point a, Point b, Point c);

/// Returns 1 if point d lies inside the circle through a, b, c, which are counter-clockwise; 0 if it lies on the
/// circle; -1 if it lies outside.
int inCircle(Point a, Point b, Point c, Point d);

}  // namespace circle_voronoi::exact
