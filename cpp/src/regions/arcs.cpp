// SPDX-License-Identifier: GPL-3.0-or-later
#include "arcs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>

#include "at.h"
#include "guarded.h"

namespace circle_voronoi {
namespace {

/// What is nearer than this share of coordinates may be on the boundary but for rounding.
constexpr double kNearBoundary = 0x1p-36;
constexpr std::int32_t kUnknown = std::numeric_limits<std::int32_t>::min();

[[noreturn]] void refuseOpenBoundary() {
  throw Refusal{errorWith(ErrorCode::internal, "The boundary of the region is not closed in the diagram.")};
}

}  // namespace

Arcs::Arcs(const Diagram& diagram, const Crossings& crossings) : diagram_(diagram), crossings_(crossings) {
  sortCrossings();
  findLevels();
  makeArcs();
}

Arcs::Arcs(const Diagram& diagram, const Crossings& crossings, const Region& region,
           std::span<const CircleIndex> circles)
    : diagram_(diagram), crossings_(crossings) {
  sortCrossings();
  findLevels(region, circles);
  makeArcs();
}

void Arcs::sortCrossings() {
  const auto& all = crossings_.all;
  order_.resize(all.size());
  std::iota(order_.begin(), order_.end(), 0);
  const auto key = [&](std::int32_t c) { return std::tuple(std::int32_t{all[at(c)].edge}, all[at(c)].parameter, c); };
  std::ranges::sort(order_, {}, key);
  rows_.assign(diagram_.edges.size(), kNone);
  for (std::size_t k = 0; k < order_.size(); ++k) {
    const EdgeIndex edge = all[at(order_[k])].edge;
    if (rows_[at(edge)] != kNone) continue;
    rows_[at(edge)] = static_cast<std::int32_t>(crossed_.size());
    crossed_.push_back(edge);
    orderStart_.push_back(static_cast<std::int32_t>(k));
  }
  orderStart_.push_back(static_cast<std::int32_t>(order_.size()));
}

/// How much higher the level is at the end of an edge than at its start.
std::int32_t Arcs::riseAlong(EdgeIndex edge) const {
  const std::int32_t row = rows_[at(edge)];
  if (row == kNone) return 0;
  std::int32_t sum = 0;
  for (std::int32_t k = orderStart_[at(row)]; k < orderStart_[at(row) + 1]; ++k) {
    sum += crossings_.all[at(order_[at(k)])].isEntry ? 1 : -1;
  }
  return sum;
}

void Arcs::findLevels() {
  levels_.assign(diagram_.vertices.size(), kUnknown);
  std::vector<VertexIndex> pending;
  const auto reach = [&](VertexIndex vertex, std::int32_t level) {
    if (levels_[at(vertex)] == kUnknown) {
      levels_[at(vertex)] = level;
      pending.push_back(vertex);
    } else if (levels_[at(vertex)] != level) {
      refuseOpenBoundary();
    }
  };
  for (std::size_t e = 0; e < diagram_.edges.size(); ++e) {
    const Edge& edge = diagram_.edges[e];
    const auto index = static_cast<std::int32_t>(e);
    if (edge.start == kNone && edge.end != kNone) reach(edge.end, riseAlong(index));
    if (edge.end == kNone && edge.start != kNone) reach(edge.start, -riseAlong(index));
    if (edge.start == kNone && edge.end == kNone && riseAlong(index) != 0) refuseOpenBoundary();
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
  for (const std::int32_t level : levels_) {
    if (level == kUnknown) {
      throw Refusal{errorWith(ErrorCode::internal, "The edges of the diagram do not hang together.")};
    }
  }
}

void Arcs::findLevels(const Region& region, std::span<const CircleIndex> circles) {
  levels_.assign(diagram_.vertices.size(), kUnknown);
  std::vector<std::uint8_t> isChosen(diagram_.circles.size(), 0);
  for (const CircleIndex circle : circles) isChosen[at(circle)] = 1;
  std::vector<VertexIndex> group;
  const auto reach = [&](VertexIndex vertex, std::int32_t level) {
    if (levels_[at(vertex)] == kUnknown) {
      levels_[at(vertex)] = level;
      group.push_back(vertex);
    } else if (levels_[at(vertex)] != level) {
      refuseOpenBoundary();
    }
  };
  for (const CircleIndex circle : circles) {
    for (const SideIndex first : diagram_.sides(circle)) {
      const VertexIndex origin = diagram_.originOf(first);
      if (origin == kNone || levels_[at(origin)] != kUnknown) continue;
      // All vertices that edges of the cells lead to, by their level above that of the first.
      std::optional<std::int32_t> base;
      group.clear();
      reach(origin, 0);
      for (std::size_t k = 0; k < group.size(); ++k) {
        const std::int32_t level = levels_[at(group[k])];
        for (const SideIndex side : diagram_.links.vertexSides[at(group[k])]) {
          if (isChosen[at(diagram_.circleOf(side))] == 0 && isChosen[at(diagram_.neighborOf(side))] == 0) continue;
          const std::int32_t change = riseAlong(Diagram::edgeOf(side));
          const std::int32_t there = side % 2 == 0 ? level + change : level - change;
          if (diagram_.targetOf(side) == kNone) {
            base = -there;
          } else {
            reach(diagram_.targetOf(side), there);
          }
        }
      }
      if (!base) {
        // A point on the boundary may count for either side, so it counts less than any other.
        std::map<std::int32_t, std::size_t> votes;
        const auto vote = [&](Point p, std::int32_t level) {
          const double near = kNearBoundary * std::max(std::abs(p.x), std::abs(p.y));
          const bool isClear = region.sidesIn({p.x - near, p.y - near, p.x + near, p.y + near}).empty();
          votes[(region.contains(p) ? 1 : 0) - level] += isClear ? 4 * group.size() : 1;
        };
        for (const VertexIndex vertex : group) {
          const std::int32_t level = levels_[at(vertex)];
          vote({diagram_.vertices[at(vertex)].x, diagram_.vertices[at(vertex)].y}, level);
          for (const SideIndex side : diagram_.links.vertexSides[at(vertex)]) {
            const EdgeIndex edge = Diagram::edgeOf(side);
            if (side % 2 == 1 || diagram_.targetOf(side) == kNone) continue;
            if (isChosen[at(diagram_.circleOf(side))] == 0 && isChosen[at(diagram_.neighborOf(side))] == 0) continue;
            // Points between the crossings.
            const EdgeCurve curve = edgeCurve(diagram_, edge);
            double from = curve.from;
            std::int32_t here = level;
            const auto voteUpTo = [&](double to) {
              if (to > from) vote(pointAt(curve.bisector, std::sqrt(from) * std::sqrt(to)), here);
              from = to;
            };
            const std::int32_t row = rows_[at(edge)];
            for (std::int32_t k = row == kNone ? 0 : orderStart_[at(row)];
                 k < (row == kNone ? 0 : orderStart_[at(row) + 1]); ++k) {
              const Crossing& crossing = crossings_.all[at(order_[at(k)])];
              voteUpTo(crossing.parameter);
              here += crossing.isEntry ? 1 : -1;
            }
            voteUpTo(curve.to);
          }
        }
        base = std::ranges::max_element(votes, {}, [](const auto& one) { return one.second; })->first;
      }
      for (const VertexIndex vertex : group) levels_[at(vertex)] += *base;
    }
  }
  for (std::int32_t& level : levels_) {
    if (level == kUnknown) level = 0;
  }
}

bool Arcs::isInside(EdgeIndex edge) const {
  const Edge& ends = diagram_.edges[at(edge)];
  return ends.start != kNone && levelOf(ends.start) > 0;
}

void Arcs::makeArcs() {
  arcOf_.assign(crossings_.all.size(), kNone);
  std::vector<std::int32_t> entries;
  std::vector<std::int32_t> exits;
  // The arcs that are open, by layer, from the one opened first.
  std::vector<std::int32_t> open;
  for (std::size_t row = 0; row < crossed_.size(); ++row) {
    const EdgeIndex edge = crossed_[row];
    const auto first = static_cast<std::int32_t>(arcs_.size());
    arcStart_.push_back(first);
    entries.clear();
    exits.clear();
    for (std::int32_t k = orderStart_[row]; k < orderStart_[row + 1]; ++k) {
      const std::int32_t crossing = order_[at(k)];
      (crossings_.all[at(crossing)].isEntry ? entries : exits).push_back(crossing);
    }
    std::int32_t level = levelOf(diagram_.edges[at(edge)].start);
    const auto begin = [&](std::int32_t crossing, std::int32_t layer) {
      open.push_back(static_cast<std::int32_t>(arcs_.size()));
      if (crossing != kNone) arcOf_[at(crossing)] = open.back();
      arcs_.push_back({edge, crossing, kNone, layer});
    };
    const auto end = [&](std::int32_t crossing) {
      arcs_[at(open.back())].end = crossing;
      arcOf_[at(crossing)] = open.back();
      open.pop_back();
    };
    open.clear();
    for (std::int32_t layer = 1; layer <= level; ++layer) begin(kNone, layer);
    for (std::int32_t layer = 0; layer > level; --layer) begin(kNone, layer);
    std::size_t entry = 0;
    std::size_t exit = 0;
    while (entry < entries.size() || exit < exits.size()) {
      const bool enters = entry < entries.size() && (level < 1 || exit == exits.size());
      const std::int32_t crossing = enters ? entries[entry++] : exits[exit++];
      const std::int32_t layer = enters ? level + 1 : level;
      if (enters == (layer > 0)) {
        begin(crossing, layer);
      } else {
        end(crossing);
      }
      level += enters ? 1 : -1;
    }
  }
  arcStart_.push_back(static_cast<std::int32_t>(arcs_.size()));
}

std::span<const Arc> Arcs::of(EdgeIndex edge) const {
  const std::size_t row = at(rows_[at(edge)]);
  return std::span(arcs_).subspan(at(arcStart_[row]), at(arcStart_[row + 1] - arcStart_[row]));
}

std::int32_t Arcs::atVertex(EdgeIndex edge, bool isAtStart, std::int32_t layer) const {
  const auto its = of(edge);
  const auto found = std::ranges::find_if(
      its, [&](const Arc& arc) { return arc.layer == layer && (isAtStart ? arc.start : arc.end) == kNone; });
  return static_cast<std::int32_t>(&*found - arcs_.data());
}

}  // namespace circle_voronoi
