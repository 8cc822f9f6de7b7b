// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/metric.h"
#include "circle_voronoi/point.h"

namespace circle_voronoi {

/// The bisector of two circles: the points at the same distance from both. It is one branch of a hyperbola. Its foci
/// are the centers, its axis has length 2 |a| = |r_left - r_right|, and it bends around the smaller circle. With the
/// center of the smaller circle as the origin,
///
///     point(s) = origin + (apex - |a| (s - 1)^2 / (2 s)) along + b (s - 1 / s) / 2 across,      0 < s < infinity,
///
/// so s = 1 is the apex, on the line of centers, and with growing s the left circle is on the left. With s = e^t this
/// is the usual (|a| cosh t, b sinh t), but without cancellation near the smaller circle and without functions that
/// differ between platforms. For equal radii a is 0 and the branch is a straight line, as it is for the other metrics.
///
/// Multiplying s by a number is an affine map of the branch onto itself. So the ratio of the parameters of its ends
/// determines how curved an arc is, wherever it lies.
struct Bisector {
  Point left;       ///< the focus of the left circle: its center
  Point right;      ///< the focus of the right circle
  double a = 0;     ///< (r_left - r_right) / 2
  double b = 0;     ///< positive, with a^2 + b^2 = c^2, where c is half the distance of the centers
  Point origin;     ///< the focus of the smaller circle; the left one if the radii are equal
  Vector along;     ///< unit vector from the origin to the other focus
  Vector across;    ///< unit vector perpendicular to `along`, with the left circle on its left
  double apex = 0;  ///< the distance c - |a| from the origin to the apex
};

/// Returns the bisector of two circles that both have a cell. For Metric::power `apex` is where the radical axis
/// crosses the line of centers, and may be negative. `weights`: as in Options; for Metric::power only.
[[nodiscard]] CIRCLE_VORONOI_API Bisector bisector(const Circle& left, const Circle& right,
                                                   Metric metric = Metric::circles, bool weights = false);

/// Returns the point with parameter s.
[[nodiscard]] CIRCLE_VORONOI_API Point pointAt(const Bisector& bisector, double s);

/// Returns the parameter of the point of the bisector nearest to `p`. Precondition: `p` lies on it up to rounding.
[[nodiscard]] CIRCLE_VORONOI_API double parameterAt(const Bisector& bisector, Point p);

/// An arc of a bisector, from parameter `from` to parameter `to` >= `from`.
///
/// An end at infinity has the parameter 0 or infinity. Any other end is the point `start` or `end`. The ends of an edge
/// are its vertices bit for bit, so arcs that meet in a vertex meet exactly. An edge of length zero has equal
/// parameters.
struct EdgeCurve {
  Bisector bisector;
  double from = 0;
  double to = std::numeric_limits<double>::infinity();
  Point start;
  Point end;

  [[nodiscard]] bool isStraight() const { return bisector.a == 0; }
  [[nodiscard]] bool startsAtInfinity() const { return from == 0; }
  [[nodiscard]] bool endsAtInfinity() const { return to == std::numeric_limits<double>::infinity(); }
  [[nodiscard]] bool isBounded() const { return !startsAtInfinity() && !endsAtInfinity(); }
};

/// Returns the curve of an edge.
[[nodiscard]] CIRCLE_VORONOI_API EdgeCurve edgeCurve(const Diagram& diagram, EdgeIndex edge);

/// Returns the curve of a side, with its cell on the left.
[[nodiscard]] CIRCLE_VORONOI_API EdgeCurve sideCurve(const Diagram& diagram, SideIndex side);

/// Returns the same arc in the opposite direction. Left and right are swapped.
[[nodiscard]] CIRCLE_VORONOI_API EdgeCurve reversed(const EdgeCurve& curve);

/// Returns the straight segment from `start` to `end`. Precondition: they differ.
[[nodiscard]] CIRCLE_VORONOI_API EdgeCurve segment(Point start, Point end);

/// A conic section as a rational quadratic Bezier curve whose points have the weights 1, `weight`, 1.
struct RationalBezier {
  Point start;
  Point control;
  Point end;
  double weight = 1;
};

/// Returns the exact form of an arc. Precondition: the arc is bounded.
[[nodiscard]] CIRCLE_VORONOI_API RationalBezier rationalBezier(const EdgeCurve& curve);

/// Returns the point with parameter u, 0 <= u <= 1.
[[nodiscard]] CIRCLE_VORONOI_API Point pointAt(const RationalBezier& bezier, double u);

struct CubicBezier {
  Point start;
  Point control1;
  Point control2;
  Point end;
};

/// Approximates an arc by cubic Bezier curves that stay within `tolerance` of it. Each curve is as long as the
/// tolerance allows. It shares the arc's tangents at both ends and touches the arc in the middle, or it is straight. A
/// tolerance below 1e-12 of the arc's extent is raised to that. Precondition: the arc is bounded.
[[nodiscard]] CIRCLE_VORONOI_API std::vector<CubicBezier> cubicBeziers(const EdgeCurve& curve, double tolerance);

/// Approximates an arc by a polyline that stays within `tolerance` of it, with chords as long as the tolerance allows.
/// Returns its points, at least two. A tolerance below 1e-9 of the arc's extent is raised to that. Precondition: the
/// arc is bounded.
[[nodiscard]] CIRCLE_VORONOI_API std::vector<Point> polyline(const EdgeCurve& curve, double tolerance);

/// Returns the length of an arc, up to rounding of its ends. It is an elliptic integral, computed by Carlson's
/// duplication in a few dozen square roots. Precondition: the arc is bounded.
[[nodiscard]] CIRCLE_VORONOI_API double arcLength(const EdgeCurve& curve);

}  // namespace circle_voronoi
