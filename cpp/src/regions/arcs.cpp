// SPDX-License-Identifier: GPL-3.0-or-later
#include "arcs.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <span>

#include "at.h"
#include "crossing_order.h"
#include "shifted_signs.h"
#include "side_after.h"

namespace circle_voronoi {
namespace {

constexpr std::int32_t kUnknown = std::numeric_limits<std::int32_t>::min();

/// Returns how often the boundary of a region winds around the vertex where a side begins.
std::int32_t windingAround(const Diagram& diagram, const Region& region, const ShiftedSigns& signs,
                           SideIndex beginning) {
  const VertexIndex vertex = diagram.originOf(beginning);
  const Vertex& v = diagram.vertices[at(vertex)];
  const double error = signs.errorOf(vertex);
  const Box bounds = region.bounds();
  const auto isBeyond = [&](double value, double min, double max) {
    return value + error < min || value - error > max;
  };
  if (isBeyond(v.x, bounds.minX, bounds.maxX) || isBeyond(v.y, bounds.minY, bounds.maxY)) return 0;
  // Away from the boundary the vertex is where its rounded place is.
  const std::array<Point, 2> ray = {Point{v.x, v.y}, Point{std::max(bounds.maxX, v.x), v.y}};
  if (region.sidesNear(std::span(ray).first(1), error).empty()) return region.contains({v.x, v.y}) ? 1 : 0;
  const auto isAbove = [&](Point p) {
    // A horizontal line through the point, to the right.
    const Point right = {p.x == 0 ? 1 : p.x > 0 ? 2 * p.x : -p.x, p.y};
    return signs.sideOfEnd(beginning, false, {p, right}) < 0;
  };
  std::int32_t winding = 0;
  for (const RegionSideIndex side : region.sidesNear(ray, error)) {
    const Point from = region.points()[at(side)];
    const Point to = region.points()[at(sideAfter(region, side))];
    const bool goesUp = isAbove(to);
    if (isAbove(from) == goesUp) continue;
    // The ray crosses the side if the vertex lies left of a side that goes up, or right of a side that goes down.
    if ((signs.sideOfEnd(beginning, false, {from, to}) > 0) == goesUp) winding += goesUp ? 1 : -1;
  }
  return winding;
}

}  // namespace

Arcs::Arcs(const Diagram& diagram, const Region& region, const ClipScope& scope, const Crossings& crossings)
    : diagram_(diagram), scope_(scope), crossings_(crossings), crossed_(std::vector<std::int32_t>()) {
  sortCrossings(region);
  if (scope.isAll()) {
    findLevels();
  } else {
    findLevels(region);
  }
  makeArcs();
}

void Arcs::sortCrossings(const Region& region) {
  const auto& all = crossings_.all;
  order_.resize(all.size());
  std::iota(order_.begin(), order_.end(), 0);
  const auto edgeOf = [&](std::int32_t c) { return all[at(c)].edge; };
  std::ranges::stable_sort(order_, {}, edgeOf);
  const CrossingOrder crossingOrder(diagram_, region);
  std::vector<std::int32_t> crossed;
  for (std::size_t k = 0; k < order_.size();) {
    const std::size_t first = k;
    while (k < order_.size() && edgeOf(order_[k]) == edgeOf(order_[first])) ++k;
    crossed.push_back(edgeOf(order_[first]));
    orderStart_.push_back(static_cast<std::int32_t>(first));
    // A stable sort ends even if the diagram is wrong and the order is none.
    std::ranges::stable_sort(std::span(order_).subspan(first, k - first), [&](std::int32_t c, std::int32_t d) {
      return crossingOrder.isBefore(all[at(c)], all[at(d)]);
    });
  }
  orderStart_.push_back(static_cast<std::int32_t>(order_.size()));
  if (scope_.isAll()) {
    isCrossed_.assign(diagram_.edges.size(), false);
    for (const std::int32_t edge : crossed) isCrossed_[at(edge)] = true;
  }
  crossed_ = Chosen(std::move(crossed));
}

/// The level at the end of an edge minus the level at its start.
std::int32_t Arcs::riseAlong(EdgeIndex edge) const {
  if (!isCrossed(edge)) return 0;
  const std::int32_t row = crossed_.rowOf(edge);
  std::int32_t sum = 0;
  for (std::int32_t k = orderStart_[at(row)]; k < orderStart_[at(row) + 1]; ++k) {
    sum += crossings_.all[at(order_[at(k)])].isEntry ? 1 : -1;
  }
  return sum;
}

/// Finds the levels from infinity on. Whether all ways to a vertex lead to one level is for the judge (judge_clip.h).
void Arcs::findLevels() {
  levels_.assign(diagram_.vertices.size(), kUnknown);
  std::vector<VertexIndex> pending;
  const auto reach = [&](VertexIndex vertex, std::int32_t level) {
    if (levels_[at(vertex)] != kUnknown) return;
    levels_[at(vertex)] = level;
    pending.push_back(vertex);
  };
  for (std::size_t e = 0; e < diagram_.edges.size(); ++e) {
    const Edge& edge = diagram_.edges[e];
    const auto index = static_cast<std::int32_t>(e);
    if (edge.start == kNone && edge.end != kNone) reach(edge.end, riseAlong(index));
    if (edge.end == kNone && edge.start != kNone) reach(edge.start, -riseAlong(index));
  }
  while (!pending.empty()) {
    const VertexIndex vertex = pending.back();
    pending.pop_back();
    const std::int32_t level = levels_[at(vertex)];
    for (const SideIndex side : diagram_.links.vertexSides[at(vertex)]) {
      const VertexIndex target = diagram_.targetOf(side);
      if (target == kNone) continue;
      const std::int32_t change = riseAlong(Diagram::edgeOf(side));
      reach(target, side % 2 == 0 ? level + change : level - change);
    }
  }
}

/// Returns the level where a side begins whose edge is crossed.
std::int32_t Arcs::levelBefore(SideIndex side) const {
  const std::int32_t row = crossed_.rowOf(Diagram::edgeOf(side));
  const bool isAlong = side % 2 == 0;
  const std::int32_t first = isAlong ? orderStart_[at(row)] : orderStart_[at(row) + 1] - 1;
  return crossings_.all[at(order_[at(first)])].isEntry == isAlong ? 0 : 1;
}

/// Finds the levels of the vertices of some cells, around each cell from the level of one vertex: one before a
/// crossing, or else of any vertex.
void Arcs::findLevels(const Region& region) {
  levels_.assign(scope_.vertices.size(), kUnknown);
  const ShiftedSigns signs(diagram_);
  const auto levelOf = [&](VertexIndex vertex) -> std::int32_t& { return levels_[at(scope_.vertices.rowOf(vertex))]; };
  for (std::size_t row = 0; row < scope_.cells.size(); ++row) {
    const auto sides = diagram_.sides(scope_.cells[row]);
    const auto crossed = std::ranges::find_if(sides, [&](SideIndex side) { return isCrossed(Diagram::edgeOf(side)); });
    std::int32_t level = crossed == sides.end() ? kUnknown : levelBefore(*crossed);
    for (const SideIndex side : sides) {
      const VertexIndex origin = diagram_.originOf(side);
      const VertexIndex target = diagram_.targetOf(side);
      if (origin == kNone) level = 0;
      if (origin != kNone && levelOf(origin) != kUnknown) level = levelOf(origin);
      if (level == kUnknown) level = windingAround(diagram_, region, signs, side);
      if (origin != kNone) levelOf(origin) = level;
      const std::int32_t change = riseAlong(Diagram::edgeOf(side));
      level += side % 2 == 0 ? change : -change;
      if (target != kNone && levelOf(target) == kUnknown) levelOf(target) = level;
    }
  }
}

/// If entries and exits do not alternate, the judge refuses the clip.
void Arcs::makeArcs() {
  arcOf_.assign(crossings_.all.size(), kNone);
  const auto add = [&](EdgeIndex edge, std::int32_t start, std::int32_t end) {
    for (const std::int32_t crossing : {start, end}) {
      if (crossing != kNone) arcOf_[at(crossing)] = static_cast<std::int32_t>(arcs_.size());
    }
    arcs_.push_back({edge, start, end});
  };
  for (std::size_t row = 0; row < crossed_.size(); ++row) {
    const EdgeIndex edge = crossed_[row];
    arcStart_.push_back(static_cast<std::int32_t>(arcs_.size()));
    bool isIn = isInside(diagram_.edges[at(edge)].start);
    std::int32_t start = kNone;
    for (std::int32_t k = orderStart_[row]; k < orderStart_[row + 1]; ++k) {
      const std::int32_t crossing = order_[at(k)];
      const bool isEntry = crossings_.all[at(crossing)].isEntry;
      if (isEntry != isIn && !isEntry) add(edge, start, crossing);
      if (isEntry) start = crossing;
      isIn = isEntry;
    }
    if (isIn) add(edge, start, kNone);
  }
  arcStart_.push_back(static_cast<std::int32_t>(arcs_.size()));
}

std::span<const Arc> Arcs::of(EdgeIndex edge) const {
  const std::size_t row = at(crossed_.rowOf(edge));
  return std::span(arcs_).subspan(at(arcStart_[row]), at(arcStart_[row + 1] - arcStart_[row]));
}

std::int32_t Arcs::atVertex(EdgeIndex edge, bool isAtStart) const {
  const auto its = of(edge);
  return static_cast<std::int32_t>((isAtStart ? &its.front() : &its.back()) - arcs_.data());
}

}  // namespace circle_voronoi
