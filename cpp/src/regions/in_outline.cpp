// SPDX-License-Identifier: GPL-3.0-or-later
#include "in_outline.h"

#include <algorithm>
#include <cmath>

#include "in_circle.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

/// Whether a ray from p to the right crosses the segment from a to b.
bool crossesRay(Point a, Point b, Point p) {
  const bool isUp = b.y > p.y;
  if ((a.y > p.y) == isUp) return false;
  return isUp ? orientation(a, b, p) > 0 : orientation(a, b, p) < 0;
}

/// Whether a point lies between an arc of a circle and its chord.
bool isBeyondChord(const OutlinePiece& arc, Point p) {
  const Point start = arc.curve.start;
  const Vector chord = vectorTo(start, arc.curve.end);
  if (orientation(start, arc.curve.end, p) >= 0) return false;
  const double half = lengthOf(chord) / 2;
  const double share = std::sqrt(std::max((arc.r - half) * (arc.r + half), 0.0)) / (2 * half);
  const Point center = {start.x + chord.x / 2 - share * chord.y, start.y + chord.y / 2 + share * chord.x};
  return lengthOf(vectorTo(center, p)) < arc.r;
}

/// Whether a point lies between an arc of a bisector and its chord. The branch bends around a convex set, so the chord
/// cuts off the points between. These also lie between the ends seen across the axis, which restricts the test to arcs
/// whose chord is mostly rounding.
bool isBeyondChord(const EdgeCurve& curve, Point p) {
  const Bisector& bisector = curve.bisector;
  const int side = orientation(curve.start, curve.end, p);
  if (bisector.a == 0 || side == 0 || (side > 0) != (bisector.a > 0)) return false;
  const auto height = [&](Point q) { return dot(vectorTo(bisector.origin, q), bisector.across); };
  const auto [low, high] = std::minmax({height(curve.start), height(curve.end)});
  if (!(low < height(p) && height(p) < high)) return false;
  const double toLeft = lengthOf(vectorTo(bisector.left, p));
  const double toRight = lengthOf(vectorTo(bisector.right, p));
  return bisector.a < 0 ? toRight - toLeft > -2 * bisector.a : toLeft - toRight > 2 * bisector.a;
}

}  // namespace

bool hasInLoop(const std::vector<OutlinePiece>& loop, Point p) {
  bool isOdd = false;
  for (const OutlinePiece& piece : loop) {
    const EdgeCurve& curve = piece.curve;
    if (curve.start == curve.end) continue;
    isOdd ^= crossesRay(curve.start, curve.end, p);
    isOdd ^= piece.isOnCircle() ? isBeyondChord(piece, p) : isBeyondChord(curve, p);
  }
  return isOdd;
}

}  // namespace circle_voronoi
