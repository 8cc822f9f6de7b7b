// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/convex_polygon.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/metric.h"
#include "circle_voronoi/point.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// The bisector of two circles, the points at the same distance from both: one branch of a hyperbola whose foci are the
/// centres and whose axis has length 2 |a| = |r_left - r_right|, bent around the smaller circle. Seen from the centre
/// of the smaller circle, the origin,
///
///     point(s) = origin + (apex - |a| (s - 1)^2 / (2 s)) along + b (s - 1 / s) / 2 across,      0 < s < infinity,
///
/// so s = 1 is the apex, on the line of centres, and growing s has the left circle on its left. With s = e^t this is
/// the usual (|a| cosh t, b sinh t), without cancellation near the smaller circle and without functions that differ
/// between platforms. For equal radii a is 0 and the branch is a straight line, as it is for the other metrics.
///
/// a, b and apex are measured in `unit`, which is 1 unless the circles are so near or so far that products of lengths
/// would leave the range of doubles: curves of all circles that `compute` takes are right up to rounding.
///
/// Multiplying s by a number is an affine map of the branch onto itself: an arc is as curved as the ratio of the
/// parameters of its ends says, wherever it lies.
struct Bisector {
  Point left;       ///< the foci: the centres of the left circle
  Point right;      ///< and of the right one
  double unit = 1;  ///< of a, b and apex: 1 or a power of two
  double a = 0;     ///< (r_left - r_right) / 2
  double b = 0;     ///< a^2 + b^2 = c^2, where c is half the distance of the centres; above 0
  Point origin;     ///< the focus of the smaller circle, the left one if radii are equal
  Vector along;     ///< unit vector from the origin to the other focus
  Vector across;    ///< unit vector at right angles to it, with the left circle on its left
  double apex = 0;  ///< the distance c - |a| from the origin to the apex
};

/// The bisector of two circles with cells. For Metric::power `apex` is where the radical axis crosses the line of
/// centres, and may be negative.
Bisector bisector(const Circle& left, const Circle& right, Metric metric = Metric::circles);

Point pointAt(const Bisector& bisector, double s);

/// The parameter of the point of the bisector next to `p`, a point on it but for rounding.
double parameterAt(const Bisector& bisector, Point p);

/// An arc of a bisector, from parameter `from` to parameter `to` >= `from`. An end at infinity has the parameter 0 or
/// infinity; otherwise `start` and `end` are the ends, those of an edge its vertices bit for bit: arcs that meet in a
/// vertex meet exactly. An edge of length zero has equal parameters.
struct EdgeCurve {
  Bisector bisector;
  double from = 0;
  double to = std::numeric_limits<double>::infinity();
  Point start;
  Point end;

  bool isStraight() const { return bisector.a == 0; }
  bool startsAtInfinity() const { return from == 0; }
  bool endsAtInfinity() const { return to == std::numeric_limits<double>::infinity(); }
  bool isBounded() const { return !startsAtInfinity() && !endsAtInfinity(); }
};

/// The curve of an edge. Where the edge ends more than
/// 2^900 times as far away as the two centres are from each other, they are moved apart to 2^-900 of that: that cannot
/// be seen from there, and parameters stay in the range of doubles.
EdgeCurve edgeCurve(const Diagram& diagram, EdgeIndex edge);

/// The curve of a side, with its cell on the left.
EdgeCurve sideCurve(const Diagram& diagram, SideIndex side);

/// The same arc run through the other way: left and right change places.
EdgeCurve reversed(const EdgeCurve& curve);

/// The straight segment from `start` to `end`, which differ.
EdgeCurve segment(Point start, Point end);

/// A conic section as a rational quadratic Bezier curve, with the weights 1, `weight`, 1 of its points.
struct RationalBezier {
  Point start;
  Point control;
  Point end;
  double weight = 1;
};

/// A bounded arc exactly.
RationalBezier rationalBezier(const EdgeCurve& curve);

/// The point at 0 <= u <= 1.
Point pointAt(const RationalBezier& bezier, double u);

struct CubicBezier {
  Point start;
  Point control1;
  Point control2;
  Point end;
};

/// A bounded arc as cubic Bezier curves that keep within `tolerance` of it: each has the arc's tangents at both ends
/// and meets it in the middle, or is straight, and is as long as the tolerance allows. A tolerance below 1e-12 of the
/// arc's extent counts as that.
std::vector<CubicBezier> cubicBeziers(const EdgeCurve& curve, double tolerance);

/// A bounded arc as the points of a polyline that keeps within `tolerance` of it, two at least, with chords as long as
/// the tolerance allows. A tolerance below 1e-9 of the arc's extent counts as that.
std::vector<Point> polyline(const EdgeCurve& curve, double tolerance);

/// The pieces of an arc inside a region, in order: bounded, and several if the arc leaves the region and comes back.
std::vector<EdgeCurve> clip(const EdgeCurve& curve, const ConvexPolygon& region);

/// The length of a bounded arc, up to rounding of its ends: an elliptic integral by Carlson's duplication, which takes
/// some tens of square roots whatever the arc.
double arcLength(const EdgeCurve& curve);

}  // namespace circle_voronoi
