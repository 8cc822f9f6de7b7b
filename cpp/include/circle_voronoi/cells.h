// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/convex_polygon.h"
#include "circle_voronoi/curve.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/point.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// The circles across the sides of a cell, in their order: a circle recurs if the two share several edges.
std::vector<CircleIndex> neighbors(const Diagram& diagram, CircleIndex circle);

/// The distance of p from a circle, by the diagram's metric.
double distance(const Diagram& diagram, CircleIndex circle, Point p);

/// How much nearer p is to one circle than to another, negative if the other is nearer: the difference of their
/// distances, but without cancellation where p is far away. Of the power metric it is divided by a length.
double lead(const Diagram& diagram, CircleIndex circle, CircleIndex other, Point p);

/// Whether no circle is nearer to p, up to rounding. It suffices to ask the neighbours: a ray from the centre that
/// leaves the cell across a side stays nearer to the neighbour there, and for the power metric a cell is the
/// intersection of half-planes, one for each neighbour. False for a hidden circle.
bool contains(const Diagram& diagram, CircleIndex circle, Point p);

/// A piece of the outline of a clipped cell, with the cell on its left.
struct OutlinePiece {
  EdgeCurve curve;            ///< bounded; of an arc of a circle its chord
  SideIndex side = {};        ///< of the cell; kNone: a piece of the boundary of the region, or an arc of a circle
  CircleIndex neighbor = {};  ///< the circle on the other side; kNone likewise
  /// Of an arc of the circle around the cell's centre that a maximum distance makes: its radius, else 0. The arc is
  /// counter-clockwise and of a quarter turn at most, so that its ends and radius say where the centre is.
  double r = 0;

  bool isOnCircle() const { return r > 0; }
};

/// Closed loops of pieces, counter-clockwise, one for each component: the end of a piece is the start of the next.
/// Pieces of length zero occur.
using Outline = std::vector<std::vector<OutlinePiece>>;

/// The part of a cell inside a region: empty if they do not meet, several loops if the region cuts the cell apart.
Outline outline(const Diagram& diagram, CircleIndex circle, const ConvexPolygon& region);

/// The part of a cell whose points are up to `maxDistance` from its circle: the cell cut by the circle of radius
/// r + maxDistance around its centre. Cut so, the cells share out the union of all circles grown by that distance, and
/// no two overlap. Below 0 it is what lies so deep inside the circles. One loop, or none: a cell is star-shaped around
/// its circle's centre (finder.h), as a disc is, so that what both have in common is in one piece and has no holes.
/// Each side has one arc of it at most, as the distance grows from the apex to both ends.
///
/// Precondition: maxDistance is finite and at most kRegionLimit in absolute value; the metric is not the power.
Outline outline(const Diagram& diagram, CircleIndex circle, double maxDistance);
/// The same inside a region.
Outline outline(const Diagram& diagram, CircleIndex circle, const ConvexPolygon& region, double maxDistance);

/// Exact up to rounding: polygons, and closed forms for what lies between an arc and its chord, by square roots alone.
double area(const Outline& outline);
/// The centre of mass, likewise. Of an outline without area but for rounding it is that of its end points; (0, 0) if it
/// is empty.
Point centroid(const Outline& outline);
/// The length of all pieces, likewise (arcLength).
double perimeter(const Outline& outline);

}  // namespace circle_voronoi
