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
/// A face is three circles in counter-clockwise order around their three-touch disc. With the point at infinity it is
/// two circles and their outer tangent line: (a, b, null) has the line to the left of a -> b. No circle of a face hides
/// another.
using Face = std::array<const Circle*, 3>;

/// The other corners of a face, in order after `from`.
inline std::array<const Circle*, 2> othersOf(const Face& face, const Circle* from) {
  const auto at = static_cast<std::size_t>(std::find(face.begin(), face.end(), from) - face.begin());
  return {face[(at + 1) % 3], face[(at + 2) % 3]};
}

/// The smallest circle of a face without the point at infinity, the first of those that are as small.
inline const Circle* smallestOf(const Face& face) {
  const Circle* smallest = face[0]->r <= face[1]->r ? face[0] : face[1];
  return face[2]->r < smallest->r ? face[2] : smallest;
}

/// A direction that no drawing is likely to be aligned with: its ties are rare.
inline constexpr int kAxisX = 1009;
inline constexpr int kAxisY = 613;

/// Returns whether the face has a disc: radius + r >= 0 for its smallest circle. Always true for a face at infinity.
bool hasDisc(const Face& face);

/// The disc of a face without the point at infinity, times `unit`, a power of two. Each number is right to 48 bits of
/// itself, or of the distance from the smallest circle's center to the disc's where it cancels against that circle's.
/// None if the face has no disc or a number is beyond the doubles.
std::optional<Vertex> disc(const Face& face, double unit = 1);

/// A disc as a homogeneous point relative to the center of its smallest circle, which lies |v| / w from the disc's
/// center, with |v| about 1.
struct DiscPoint {
  Vector v;
  double w = 0;
};

/// The disc of a face without the point at infinity. Components of v are right within 2^-46, and w is within 2^-46 of
/// itself. None if the face has no disc or w is beyond the doubles.
std::optional<DiscPoint> discPoint(const Face& face);

/// Signs of the direction from circle `from`, a corner of the face, to the center of its disc: along the axis (0) or
/// along the axis turned by +90 degrees (1). At infinity: of the normal of the tangent line.
/// Precondition: hasDisc(face).
int directionSign(const Face& face, const Circle& from, int axis);

/// The sign of the cross product of two such directions, seen from the same circle.
/// Precondition: both faces have a disc, `from` as a corner, and a second corner in common.
int crossSign(const Face& first, const Face& second, const Circle& from);

/// 1 if `other`, a circle or the point at infinity, overlaps the disc of a face, 0 if it touches it, -1 if it is clear
/// of it. `from` is a corner of the face.
int overlapSign(const Face& face, const Circle* other, const Circle& from);

/// The sign that decides a near tie (refined.h): 0 if one disc touches the circles of the face and `other`, which
/// may be the point at infinity too. `from` is a corner of the face.
int touchSign(const Face& face, const Circle* other, const Circle& from);

/// Returns whether `outer` contains `inner`.
bool contains(const Circle& outer, const Circle& inner);

/// The normal of the tangent line of the face at infinity (a, b, null), times a number that makes it about as long as 1
/// at most. Each component is right within 2^-48. None if one circle contains the other.
std::optional<Vector> tangentNormal(const Circle& a, const Circle& b);

/// 1 if circle c crosses the tangent line of the face at infinity (a, b, null), 0 if it touches it, -1 if it is clear
/// of it.
int tangentSide(const Circle& a, const Circle& b, const Circle& c);

/// Returns whether c touches a common tangent line of circles a and b between the points where these do. All three
/// touch the line from the same side.
bool touchesBetween(const Circle& a, const Circle& b, const Circle& c);

/// Returns 1 if points a, b, c are counter-clockwise, -1 if they are clockwise, 0 if they are collinear.
int orientation(Point a, Point b, Point c);

/// Returns 1 if point d lies inside the circle through a, b, c, which are counter-clockwise; 0 if it lies on the
/// circle; -1 if it lies outside.
int inCircle(Point a, Point b, Point c, Point d);

}  // namespace circle_voronoi::exact
