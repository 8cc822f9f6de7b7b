// SPDX-License-Identifier: GPL-3.0-or-later
#include "in_outline.h"

#include "circle_arc.h"
#include "in_circle.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

/// A curve is followed that closely, as a share of its size.
constexpr double kFineShare = 1e-9;

/// Whether a ray from p to the right crosses the segment from a to b.
bool crossesRay(Point a, Point b, Point p) {
  const bool isUp = b.y > p.y;
  if ((a.y > p.y) == isUp) return false;
  return isUp ? orientation(a, b, p) > 0 : orientation(a, b, p) < 0;
}

}  // namespace

bool hasInLoop(const std::vector<OutlinePiece>& loop, Point p) {
  bool isOdd = false;
  for (const OutlinePiece& piece : loop) {
    const EdgeCurve& curve = piece.curve;
    const double tolerance = kFineShare * lengthOf(vectorTo(curve.start, curve.end));
    if (!(tolerance > 0)) continue;
    const std::vector<Point> points =
        piece.isOnCircle() ? polyline(circleArc(piece), tolerance) : polyline(curve, tolerance);
    for (std::size_t i = 1; i < points.size(); ++i) isOdd ^= crossesRay(points[i - 1], points[i], p);
  }
  return isOdd;
}

}  // namespace circle_voronoi
