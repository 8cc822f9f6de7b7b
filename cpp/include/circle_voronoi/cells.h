// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/curve.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/index.h"
#include "circle_voronoi/point.h"

namespace circle_voronoi {

/// Returns the circles across the sides of a cell, in the order of the sides. A circle recurs if the two cells share
/// several edges.
[[nodiscard]] CIRCLE_VORONOI_API std::vector<CircleIndex> neighbors(const Diagram& diagram, CircleIndex circle);

/// Returns the distance of p from a circle in the diagram's metric.
[[nodiscard]] CIRCLE_VORONOI_API double distanceFrom(const Diagram& diagram, CircleIndex circle, Point p);

/// Returns how much nearer p is to `circle` than to `other`: the difference of their distances, which is negative if
/// `other` is nearer. It does not cancel if p is far away. For the power metric the difference is divided by a length.
[[nodiscard]] CIRCLE_VORONOI_API double distanceDifference(const Diagram& diagram, CircleIndex circle,
                                                           CircleIndex other, Point p);

/// Returns whether a cell contains p, up to rounding. Returns false for a hidden circle.
///
/// Compares p with the neighbors only, and with the neighbors of each neighbor that is equally near up to rounding.
/// That suffices: a ray from the center that leaves the cell across a side stays nearer to the neighbor on that side.
/// For the power metric a cell is the intersection of half-planes, one for each neighbor.
[[nodiscard]] CIRCLE_VORONOI_API bool contains(const Diagram& diagram, CircleIndex circle, Point p);

/// A piece of the outline of a clipped cell, with the cell on its left.
struct OutlinePiece {
  EdgeCurve curve;            ///< bounded; for an arc of a circle, its chord
  SideIndex side = {};        ///< the side of the cell; kNone on the boundary of the region or on an arc of a circle
  CircleIndex neighbor = {};  ///< the circle on the other side; kNone where `side` is kNone
  /// The radius of the arc if a maximum distance cuts the cell here, otherwise 0. The arc belongs to a circle around
  /// the cell's center. It is counter-clockwise and at most a quarter turn, so its ends and radius determine its
  /// center.
  double r = 0;
  /// The side of the Region on which the piece lies (ClippedDiagram), otherwise kNone.
  RegionSideIndex regionSide = {};

  [[nodiscard]] bool isOnCircle() const { return r > 0; }
};

/// Closed loops of pieces, counter-clockwise, one for each component. Each piece ends where the next one starts. Some
/// pieces have length zero. The part of a cell in a Region may have holes: these are clockwise loops, after the loop
/// around them.
using Outline = std::vector<std::vector<OutlinePiece>>;

/// Returns the outline of a bounded cell. It is empty if the cell is unbounded, or there is none. ClippedDiagram clips
/// cells to a box or another region.
[[nodiscard]] CIRCLE_VORONOI_API Outline outline(const Diagram& diagram, CircleIndex circle);

/// Returns the outline of the part of a cell within `maxDistance` of its circle: the cell cut by the circle of radius r
/// + maxDistance around its center. The parts of all cells do not overlap. Together they cover the union of all circles
/// grown by that distance. If the distance is negative, they cover the points at least that deep inside the circles.
///
/// For Metric::power the distance of a point is the signed root of its power, as for Vertex::r: outside of the circle
/// the length of the tangents from the point to the circle. So the squared radius of the cutting circle is the weight
/// plus maxDistance^2, or minus it for a negative distance, as in weighted alpha complexes (H. Edelsbrunner, "The union
/// of balls and its dual shape", 1995).
///
/// The outline has at most one loop: cell and disc are both star-shaped around the center (finder.h), or both convex
/// for Metric::power, so their intersection has one component and no holes. It has at most one arc of each side,
/// because the distance grows from the apex of the side to both ends.
///
/// Precondition: maxDistance is finite and at most kRegionLimit in absolute value.
[[nodiscard]] CIRCLE_VORONOI_API Outline outlineWithin(const Diagram& diagram, CircleIndex circle, double maxDistance);
/// Returns the enclosed area, exact up to rounding: a polygon, plus the segments between arcs and their chords, whose
/// closed forms need no functions but square roots.
[[nodiscard]] CIRCLE_VORONOI_API double area(const Outline& outline);
/// Returns the center of mass, exact up to rounding. If the area is zero up to rounding, returns the center of mass of
/// the end points; (0, 0) for an empty outline.
[[nodiscard]] CIRCLE_VORONOI_API Point centroid(const Outline& outline);
/// Returns the length of all pieces (arcLength).
[[nodiscard]] CIRCLE_VORONOI_API double perimeter(const Outline& outline);

// Measures of whole cells. ClippedDiagram has those of the parts inside a box or another region.

/// Returns the area of a cell, exact up to rounding: infinity if the cell is unbounded, 0 for a hidden circle.
[[nodiscard]] CIRCLE_VORONOI_API double cellArea(const Diagram& diagram, CircleIndex circle);
/// Returns the center of mass of a cell, exact up to rounding; NaN if the cell is unbounded, or there is none.
[[nodiscard]] CIRCLE_VORONOI_API Point cellCentroid(const Diagram& diagram, CircleIndex circle);
/// Returns the perimeter of a cell, exact up to rounding: infinity if the cell is unbounded, 0 for a hidden circle.
[[nodiscard]] CIRCLE_VORONOI_API double cellPerimeter(const Diagram& diagram, CircleIndex circle);

}  // namespace circle_voronoi
