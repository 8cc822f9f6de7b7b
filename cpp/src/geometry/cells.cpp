// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/cells.h"

#include <algorithm>
#include <utility>

#include "scale.h"

namespace circle_voronoi {

Cells::Cells(std::span<const Circle> circles, const Diagram& diagram, Metric metric)
    : circles_(circles), diagram_(&diagram), metric_(metric) {
  exists_.assign(circles.size(), 1);
  for (const HiddenCircle& hidden : diagram.hidden) exists_[index(hidden.circle)] = 0;

  const auto sideCount = static_cast<std::int32_t>(2 * diagram.edges.size());
  first_.assign(circles.size() + 1, 0);
  for (std::int32_t side = 0; side < sideCount; ++side) ++first_[index(circleOf(side)) + 1];
  for (std::size_t i = 0; i < circles.size(); ++i) first_[i + 1] += first_[i];

  // The sides of a cell form one cycle, infinity included, which begins at the first. Cells in the order of their edges
  // are near to each other in memory, whatever the order of the circles.
  const std::vector<std::int32_t> next = nextSides();
  sides_.assign(index(sideCount), kNone);
  for (std::int32_t begin = 0; begin < sideCount; ++begin) {
    const std::size_t i = index(circleOf(begin));
    if (sides_[first_[i]] != kNone) continue;
    std::int32_t side = begin;
    for (std::size_t k = first_[i]; k < first_[i + 1]; ++k, side = next[index(side)]) sides_[k] = side;
  }
}

/// For each side the one that follows it counter-clockwise around its cell.
std::vector<std::int32_t> Cells::nextSides() const {
  const auto sideCount = static_cast<std::int32_t>(2 * diagram_->edges.size());
  // Each of the three cells at a vertex has one side that begins there.
  std::vector<std::int32_t> departures(3 * diagram_->vertices.size(), kNone);
  const auto departure = [&](std::int32_t vertex, std::int32_t circle) -> std::int32_t& {
    const auto& triple = diagram_->vertexCircles[index(vertex)];
    const auto slot = std::find(triple.begin(), triple.end(), circle) - triple.begin();
    return departures[3 * index(vertex) + static_cast<std::size_t>(slot)];
  };
  // A side that ends at infinity belongs to the hull's step from its neighbour to its circle, one that begins there to
  // the step from its circle to its neighbour; each step occurs once.
  using Step = std::pair<std::int32_t, std::int32_t>;
  struct Departure {
    Step step;
    std::int32_t side;
  };
  std::vector<Departure> fromInfinity;
  for (std::int32_t side = 0; side < sideCount; ++side) {
    const std::int32_t origin = originOf(side);
    if (origin == kNone) {
      fromInfinity.push_back({{circleOf(side), neighborOf(side)}, side});
    } else {
      departure(origin, circleOf(side)) = side;
    }
  }
  std::ranges::sort(fromInfinity, {}, &Departure::step);
  std::vector<std::pair<Step, Step>> followingStep;
  const auto& hull = diagram_->hull;
  for (std::size_t i = 0; hull.size() > 1 && i < hull.size(); ++i) {
    const std::int32_t circle = hull[(i + 1) % hull.size()];
    followingStep.push_back({{hull[i], circle}, {circle, hull[(i + 2) % hull.size()]}});
  }
  std::ranges::sort(followingStep);

  std::vector<std::int32_t> next(index(sideCount));
  for (std::int32_t side = 0; side < sideCount; ++side) {
    const std::int32_t target = targetOf(side);
    if (target != kNone) {
      next[index(side)] = departure(target, circleOf(side));
      continue;
    }
    const Step step = {neighborOf(side), circleOf(side)};
    const auto following = std::ranges::lower_bound(followingStep, step, {}, &std::pair<Step, Step>::first);
    next[index(side)] = std::ranges::lower_bound(fromInfinity, following->second, {}, &Departure::step)->side;
  }
  return next;
}

EdgeCurve Cells::curveOf(std::int32_t side) const {
  const EdgeCurve curve = edgeCurve(circles_, *diagram_, side / 2, metric_);
  return side % 2 == 0 ? curve : reversed(curve);
}

std::vector<std::int32_t> Cells::neighbors(std::int32_t circle) const {
  std::vector<std::int32_t> result;
  for (const std::int32_t side : sides(circle)) result.push_back(neighborOf(side));
  return result;
}

// |p - d|^2 - |p - c|^2 = (c - d) . ((p - c) + (p - d)).
double Cells::lead(std::int32_t circle, std::int32_t other, Point p) const {
  const Circle& c = circles_[index(circle)];
  const Circle& d = circles_[index(other)];
  const Vector fromCircle = {p.x - c.x, p.y - c.y};
  const Vector fromOther = {p.x - d.x, p.y - d.y};
  const double difference = metric_ == Metric::centres ? 0 : d.r - c.r;
  double size = lengthOf(fromCircle) + lengthOf(fromOther);
  if (metric_ == Metric::power) size += c.r + d.r;
  if (size == 0) return -difference;
  const Vector sum = {fromCircle.x + fromOther.x, fromCircle.y + fromOther.y};
  const double unit = unitFor(largestOf(between(d, c)));
  const double sumUnit = unitFor(std::max(largestOf(sum), size));
  const double product = dot(measuredIn(unit, between(d, c)), measuredIn(sumUnit, sum));
  if (metric_ != Metric::power) return product / (size / sumUnit) * unit - difference;
  return (product - difference / unit * ((c.r + d.r) / sumUnit)) / (size / sumUnit) * unit;
}

bool Cells::contains(std::int32_t circle, Point p) const {
  if (!exists(circle)) return false;
  return std::ranges::all_of(sides(circle), [&](std::int32_t side) { return lead(circle, neighborOf(side), p) >= 0; });
}

}  // namespace circle_voronoi
