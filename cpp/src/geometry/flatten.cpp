// SPDX-License-Identifier: GPL-3.0-or-later
#include "flatten.h"

#include <algorithm>
#include <cmath>

#include "chord.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

/// Enough to halve the turn of any arc, of less than a full turn, to less than half a turn around both foci.
constexpr int kMostRefinements = 8;

/// Steps as short as this share of coordinates and of the distance from a focus have no points between them but for
/// rounding.
constexpr double kFinestStep = 0x1p-40;

/// Returns whether a step does not turn around both foci, by less than half a turn, and can be divided.
bool isCoarse(const Bisector& bisector, Point p, Point q) {
  if (turnsAround(bisector.left, bisector.right, p, q)) return false;
  const double size = std::max(largestOf({p.x, p.y}), largestOf(vectorTo(bisector.origin, p)));
  return largestOf(vectorTo(p, q)) > kFinestStep * size;
}

/// Adds points of the arc until each step turns around both foci, by less than half a turn.
void refine(std::vector<Point>& points, const EdgeCurve& curve) {
  const Bisector& bisector = curve.bisector;
  const auto isCoarseHere = [&](Point p, Point q) { return isCoarse(bisector, p, q); };
  for (int i = 0; i < kMostRefinements; ++i) {
    if (std::ranges::adjacent_find(points, isCoarseHere) == points.end()) return;
    std::vector<Point> finer = {points.front()};
    for (std::size_t k = 1; k < points.size(); ++k) {
      const Point p = points[k - 1];
      const Point q = points[k];
      const double middle = std::sqrt(parameterAt(bisector, p)) * std::sqrt(parameterAt(bisector, q));
      if (isCoarseHere(p, q)) finer.push_back(pointAt(bisector, middle));
      finer.push_back(q);
    }
    points = std::move(finer);
  }
}

}  // namespace

bool isLeftTurn(Point p, Point q, Point r) { return turn(vectorTo(p, q), vectorTo(q, r)) > 0; }

bool turnsAround(Point left, Point right, Point p, Point q) {
  return isLeftTurn(left, p, q) && isLeftTurn(right, q, p);
}

std::vector<Point> pointsBetween(const EdgeCurve& curve, Point start, Point end, double tolerance) {
  if (start == end) return {start};
  std::vector<Point> points = polyline(curve, tolerance);
  if (!curve.isStraight()) refine(points, curve);
  points.front() = start;
  points.back() = end;
  return points;
}

bool isOneStep(const EdgeCurve& curve, double tolerance) {
  return isNearChord(curve, tolerance) && !isCoarse(curve.bisector, curve.start, curve.end);
}

}  // namespace circle_voronoi
