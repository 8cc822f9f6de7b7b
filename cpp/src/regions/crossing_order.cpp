// SPDX-License-Identifier: GPL-3.0-or-later
#include "crossing_order.h"

#include <cmath>

#include "at.h"
#include "scale.h"
#include "side_after.h"
#include "vectors.h"

namespace circle_voronoi {
namespace {

/// Generous bounds on rounding: crossings are right to 2^-44 of their side, and to rounding.
constexpr double kOfSide = 0x1p-42;
constexpr double kOfPlace = 0x1p-46;

double extentOf(Vector v) { return std::abs(v.x) + std::abs(v.y); }

}  // namespace

/// Returns the line of the side of a crossing, out of the cell on the left of the edge.
ShiftedSigns::Line CrossingOrder::lineOf(const Crossing& crossing) const {
  const Point start = region_.points()[at(crossing.side)];
  const Point end = region_.points()[at(sideAfter(region_, crossing.side))];
  return crossing.isEntry ? ShiftedSigns::Line{start, end} : ShiftedSigns::Line{end, start};
}

bool CrossingOrder::isBefore(const Crossing& p, const Crossing& q) const {
  const Edge& edge = diagram_.edges[at(p.edge)];
  const ShiftedSigns::Line line = lineOf(p);
  const ShiftedSigns::Line other = lineOf(q);
  // The height above the line of centers grows along the edge.
  const Vector across = between(diagram_.circles[at(edge.left)], diagram_.circles[at(edge.right)]);
  const double ahead = cross(across, vectorTo(p.point, q.point));
  const double error = kOfSide * (extentOf(vectorTo(line.from, line.to)) + extentOf(vectorTo(other.from, other.to))) +
                       kOfPlace * (extentOf({p.point.x, p.point.y}) + extentOf({q.point.x, q.point.y}));
  if (std::abs(ahead) > extentOf(across) * error) return ahead > 0;
  return signs_.isBefore(edge.left, edge.right, line, other);
}

}  // namespace circle_voronoi
