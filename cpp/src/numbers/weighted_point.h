// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/circle.h"
#include "circle_voronoi/point.h"
#include "two_part.h"

namespace circle_voronoi {

/// The center of a circle and its weight in a power diagram, exactly.
struct WeightedPoint {
  Point p;
  TwoPart weight;
};

/// Returns the weight of a circle in a power diagram, exactly: its squared radius or, if radii are weights, the number
/// itself.
inline TwoPart powerWeight(const Circle& c, bool areWeights) { return areWeights ? TwoPart{c.r, 0} : square(c.r); }

inline WeightedPoint weightedPoint(const Circle& c, bool areWeights) {
  return {{c.x, c.y}, powerWeight(c, areWeights)};
}

/// The power of a point p with respect to a weighted point is |p - q|^2 - w. Lifted to the height |q|^2 - w above the
/// plane, the weighted points with a cell are the corners of the lower convex hull (F. Aurenhammer, "Power diagrams:
/// properties, algorithms and applications", 1987).
///
/// Laws (laws_test.cpp):
///   powerTest(a, b, c, d) == powerTest(b, c, a, d) == powerTest(b, a, d, c) == -powerTest(b, a, c, d).
///   powerTest(a, b, c) == powerTest(b, a, c).
///   With equal weights, powerTest(a, b, c, d) == inCircle(a, b, c, d), and adding a number to all weights changes no
///   sign, if nothing is rounded.

/// Returns 1 if d lies below the plane through a, b, c, which are counter-clockwise; 0 if it lies in this plane; -1 if
/// it lies above. Numbers are rounded (limits.h).
int powerTest(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c, const WeightedPoint& d);

/// Returns 1 if c lies below the line through a and b, which have different places; 0 if it lies on this line; -1 if it
/// lies above. The three places are collinear.
int powerTest(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c);

}  // namespace circle_voronoi
