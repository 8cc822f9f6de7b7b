// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/cells.h"

#include <algorithm>

#include "scale.h"

namespace circle_voronoi {
namespace {

const Circle& circleAt(const Diagram& diagram, CircleIndex i) { return diagram.circles[static_cast<std::size_t>(i)]; }

}  // namespace

std::vector<CircleIndex> neighbors(const Diagram& diagram, CircleIndex circle) {
  std::vector<CircleIndex> result;
  for (const SideIndex side : diagram.sides(circle)) result.push_back(diagram.neighborOf(side));
  return result;
}

double distanceFrom(const Diagram& diagram, CircleIndex circle, Point p) {
  return distance(diagram.metric, circleAt(diagram, circle), p);
}

// |p - d|^2 - |p - c|^2 = (c - d) . ((p - c) + (p - d)).
double lead(const Diagram& diagram, CircleIndex circle, CircleIndex other, Point p) {
  const Circle& c = circleAt(diagram, circle);
  const Circle& d = circleAt(diagram, other);
  const Vector fromCircle = {p.x - c.x, p.y - c.y};
  const Vector fromOther = {p.x - d.x, p.y - d.y};
  const double difference = diagram.metric == Metric::centers ? 0 : d.r - c.r;
  double size = lengthOf(fromCircle) + lengthOf(fromOther);
  if (diagram.metric == Metric::power) size += c.r + d.r;
  if (size == 0) return -difference;
  const Vector sum = {fromCircle.x + fromOther.x, fromCircle.y + fromOther.y};
  const double unit = unitFor(largestOf(between(d, c)));
  const double sumUnit = unitFor(std::max(largestOf(sum), size));
  const double product = dot(measuredIn(unit, between(d, c)), measuredIn(sumUnit, sum));
  if (diagram.metric != Metric::power) return product / (size / sumUnit) * unit - difference;
  return (product - difference / unit * ((c.r + d.r) / sumUnit)) / (size / sumUnit) * unit;
}

bool contains(const Diagram& diagram, CircleIndex circle, Point p) {
  if (!diagram.hasCell(circle)) return false;
  return std::ranges::all_of(diagram.sides(circle),
                             [&](SideIndex side) { return lead(diagram, circle, diagram.neighborOf(side), p) >= 0; });
}

}  // namespace circle_voronoi
