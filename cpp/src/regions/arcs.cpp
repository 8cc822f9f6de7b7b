// SPDX-License-Identifier: GPL-3.0-or-later
#include "arcs.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

#include "at.h"
#include "guarded.h"

namespace circle_voronoi {
namespace {

[[noreturn]] void refuseOpenBoundary() {
  throw Refusal{errorWith(ErrorCode::internal, "The boundary of the region is not closed in the diagram.")};
}

}  // namespace

Arcs::Arcs(const Diagram& diagram, const Crossings& crossings) : diagram_(diagram), crossings_(crossings) {
  sortCrossings();
  findLevels();
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

void Arcs::findLevels() {
  constexpr std::int32_t kUnknown = std::numeric_limits<std::int32_t>::min();
  levels_.assign(diagram_.vertices.size(), kUnknown);
  // How much higher the level is at the end of an edge than at its start.
  const auto rise = [&](EdgeIndex edge) {
    const std::int32_t row = rows_[at(edge)];
    if (row == kNone) return 0;
    std::int32_t sum = 0;
    for (std::int32_t k = orderStart_[at(row)]; k < orderStart_[at(row) + 1]; ++k) {
      sum += crossings_.all[at(order_[at(k)])].isEntry ? 1 : -1;
    }
    return sum;
  };
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
    if (edge.start == kNone && edge.end != kNone) reach(edge.end, rise(index));
    if (edge.end == kNone && edge.start != kNone) reach(edge.start, -rise(index));
    if (edge.start == kNone && edge.end == kNone && rise(index) != 0) refuseOpenBoundary();
  }
  while (!pending.empty()) {
    const VertexIndex vertex = pending.back();
    pending.pop_back();
    const std::int32_t level = levels_[at(vertex)];
    for (const SideIndex side : diagram_.links.vertexSides[at(vertex)]) {
      const VertexIndex target = diagram_.targetOf(side);
      if (target == kNone) continue;
      const std::int32_t change = rise(Diagram::edgeOf(side));
      reach(target, side % 2 == 0 ? level + change : level - change);
    }
  }
  for (const std::int32_t level : levels_) {
    if (level == kUnknown) {
      throw Refusal{errorWith(ErrorCode::internal, "The edges of the diagram do not hang together.")};
    }
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
