// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "dual.h"
#include "judge.h"
#include "weighted_point.h"

namespace circle_voronoi {

/// Judges whether `dual` is the dual of the power diagram of `sites`, all of which have a corner there. Takes linear
/// time.
///
/// Theorem. Let finite triangles, each counter-clockwise, be glued along their edges, and let the edges that are left
/// form a convex polygon that goes around once. Then the triangles cover the polygon once: a point in none of the edges
/// lies in as many triangles as the polygon goes around it. If moreover no site opposite an edge lies below the plane
/// through the lifted corners of the triangle on the other side, the lifted triangles are a function that is convex
/// across each edge, and so convex. So they are the lower hull of the lifted sites, whose dual is the power diagram
/// (F. Aurenhammer, 1987).
///
/// With m sites there are 2 m - 2 faces, infinite ones included, if and only if each site is a corner of one. Where all
/// sites lie on a line, no face is finite, and the neighbors of infinity must lie there in order, none above the line
/// through its lifted neighbors.
///
/// Sites with a cell that has no interior may be corners or hidden.
Verdict judgePower(std::span<const WeightedPoint> sites, const Dual& dual);

/// A weighted point that may be hidden, and a corner of a face or an edge of the dual that contains its place.
struct HiddenPoint {
  WeightedPoint point;
  int beside = kNone;
};

/// Judges whether points have no cell of a power diagram, whose dual has been judged: each lies in a face, or where all
/// sites lie on a line on an edge, and not below the lifted corners. The verdict's circle is the index of the first
/// point that is not hidden. Takes linear time if each face is near the corner that is named.
Verdict judgeHiddenPoints(std::span<const WeightedPoint> sites, const Dual& dual, std::span<const HiddenPoint> points);

/// Returns a face of a dual that contains a place, or one at infinity if the place lies outside the hull. `start` is a
/// finite face; the walk goes from face to face toward the place, and ends in faces of a power diagram. In others it
/// gives up and returns kNone.
int faceAround(std::span<const WeightedPoint> sites, const Dual& dual, Point place, int start);

/// Returns a half-edge of an edge of a dual that contains a place, with all sites on a line, or kNone if there is none.
/// `start` is a half-edge between two sites; the walk goes from edge to edge.
int edgeAround(std::span<const WeightedPoint> sites, const Dual& dual, Point place, int start);

}  // namespace circle_voronoi
