// SPDX-License-Identifier: GPL-3.0-or-later
#include "judge_clip.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "at.h"
#include "compensated_sum.h"
#include "shifted_signs.h"
#include "sort_unique.h"

namespace circle_voronoi {
namespace {

constexpr const char* kLevels = "The boundary of the region does not wind around each vertex once or not at all.";
constexpr const char* kArcs = "The crossings of the region and the edges do not pair up.";
constexpr const char* kBoundary = "The boundary of the region does not go from cell to cell.";
constexpr const char* kAreas = "The areas of the cells do not make up the region.";

/// Generous bounds on rounding, relative to lengths.
constexpr double kJudgeRounding = 0x1p-40;

class Judge {
 public:
  explicit Judge(const ClipRecord& clip) : clip_(clip) {}

  const char* fault() const {
    if (!haveLevels()) return kLevels;
    if (!haveArcs()) return kArcs;
    if (!hasBoundary()) return kBoundary;
    return nullptr;
  }

 private:
  bool isCrossing(std::int32_t crossing) const { return crossing >= 0 && at(crossing) < clip_.crossings.all.size(); }
  bool isInside(VertexIndex vertex) const {
    return vertex != kNone && clip_.levels[at(clip_.scope.vertices.rowOf(vertex))] == 1;
  }
  bool isChosen(CircleIndex circle) const { return clip_.scope.cells.has(circle); }

  bool haveLevels() const {
    if (clip_.levels.size() != clip_.scope.vertices.size()) return false;
    if (std::ranges::any_of(clip_.levels, [](std::int32_t level) { return level != 0 && level != 1; })) return false;
    const Chosen& edges = clip_.scope.edges;
    std::vector<std::int32_t> rise(edges.size(), 0);
    for (const Crossing& crossing : clip_.crossings.all) {
      if (crossing.edge < 0 || at(crossing.edge) >= clip_.diagram.edges.size() || !edges.has(crossing.edge)) {
        return false;
      }
      rise[at(edges.rowOf(crossing.edge))] += crossing.isEntry ? 1 : -1;
    }
    for (std::size_t row = 0; row < rise.size(); ++row) {
      const Edge& edge = clip_.diagram.edges[at(edges[row])];
      const int change = (isInside(edge.end) ? 1 : 0) - (isInside(edge.start) ? 1 : 0);
      if (rise[row] != change) return false;
    }
    return true;
  }

  bool haveArcs() const {
    // The number of arcs that end at each crossing, and for each edge the number of arcs that begin and end at
    // vertices.
    std::vector<std::int32_t> ends(clip_.crossings.all.size(), 0);
    const Chosen& edges = clip_.scope.edges;
    std::vector<std::int32_t> atVertices(edges.size(), 0);
    std::vector<std::uint8_t> isCrossed(edges.size(), 0);
    const auto use = [&](std::int32_t crossing, EdgeIndex edge, bool isStart) {
      if (!isCrossing(crossing)) return false;
      const Crossing& its = clip_.crossings.all[at(crossing)];
      ++ends[at(crossing)];
      return its.edge == std::int32_t{edge} && its.isEntry == isStart;
    };
    for (const Crossing& crossing : clip_.crossings.all) isCrossed[at(edges.rowOf(crossing.edge))] = 1;
    for (const Arc& arc : clip_.arcs) {
      if (arc.edge < 0 || at(arc.edge) >= clip_.diagram.edges.size() || !edges.has(arc.edge)) return false;
      const Edge& edge = clip_.diagram.edges[at(arc.edge)];
      if (arc.start != kNone && !use(arc.start, arc.edge, true)) return false;
      if (arc.end != kNone && !use(arc.end, arc.edge, false)) return false;
      if (arc.start == kNone && !isInside(edge.start)) return false;
      if (arc.end == kNone && !isInside(edge.end)) return false;
      atVertices[at(edges.rowOf(arc.edge))] += (arc.start == kNone ? 1 : 0) + (arc.end == kNone ? 1 : 0);
    }
    if (std::ranges::any_of(ends, [](std::int32_t count) { return count != 1; })) return false;
    for (std::size_t row = 0; row < atVertices.size(); ++row) {
      const Edge& edge = clip_.diagram.edges[at(edges[row])];
      const int inside = (isInside(edge.start) ? 1 : 0) + (isInside(edge.end) ? 1 : 0);
      if (isCrossed[row] != 0 && atVertices[row] != inside) return false;
    }
    return true;
  }

  bool hasBoundary() const {
    const auto& [all, next, isOnSideOfNext, rings] = clip_.crossings;
    if (next.size() != all.size() || isOnSideOfNext.size() != all.size()) return false;
    const auto cellOf = [&](const Crossing& crossing, bool isAfter) {
      const Edge& edge = clip_.diagram.edges[at(crossing.edge)];
      return crossing.isEntry == isAfter ? edge.right : edge.left;
    };
    std::vector<std::uint8_t> isEnd(all.size(), 0);
    std::vector<std::int32_t> crossedRings;
    for (std::size_t c = 0; c < all.size(); ++c) {
      const std::int32_t side = all[c].side;
      if (side < 0 || at(side) >= clip_.region.sideCount() || !(all[c].share >= 0 && all[c].share <= 1)) return false;
      const std::int32_t ring = clip_.region.ringOf(side);
      if (crossedRings.empty() || crossedRings.back() != ring) crossedRings.push_back(ring);
      const CircleIndex cell = cellOf(all[c], true);
      if (!isChosen(cell)) continue;
      if (!isCrossing(next[c]) || isEnd[at(next[c])] != 0) return false;
      isEnd[at(next[c])] = 1;
      const Crossing& to = all[at(next[c])];
      if (cellOf(to, false) != cell || clip_.region.ringOf(to.side) != ring) return false;
      if (isOnSideOfNext[c] != 0 && to.side != side) return false;
    }
    for (std::size_t c = 0; c < all.size(); ++c) {
      if (isChosen(cellOf(all[c], false)) && isEnd[c] == 0) return false;
    }
    sortUnique(crossedRings);
    std::vector<std::int32_t> uncrossedRings;
    for (const auto& [cell, ring] : rings) {
      if (ring < 0 || at(ring) >= clip_.region.ringCount()) return false;
      if (!isChosen(cell) || !clip_.diagram.hasCell(cell)) return false;
      if (std::ranges::binary_search(crossedRings, ring)) return false;
      uncrossedRings.push_back(ring);
    }
    sortUnique(uncrossedRings);
    if (uncrossedRings.size() != rings.size()) return false;
    return !clip_.scope.isAll() || clip_.diagram.hull.empty() ||
           crossedRings.size() + uncrossedRings.size() == clip_.region.ringCount();
  }

  const ClipRecord& clip_;
};

}  // namespace

const char* faultOf(const ClipRecord& clip) { return Judge(clip).fault(); }

const char* faultOf(const ClipRecord& clip, const CellMoments& moments) {
  if (clip.diagram.hull.empty()) return nullptr;
  const Box box = clip.region.bounds();
  const double size = (box.maxX - box.minX) + (box.maxY - box.minY);
  const ShiftedSigns signs(clip.diagram);
  double mostOff = kJudgeRounding * size;
  for (std::size_t v = 0; v < clip.levels.size(); ++v) {
    if (clip.levels[v] == 1) mostOff = std::max(mostOff, signs.errorOf(clip.scope.vertices[v]));
  }
  const double perimeter = moments.boundary;
  CompensatedSum sum;
  for (std::size_t i = 0; i < moments.moments.size(); ++i) {
    const double area = moments.area(i);
    if (!(area >= -mostOff * (perimeter + size))) return kAreas;
    sum += area;
  }
  // Both cells of an edge see its ends at the same places, however far these are off.
  const double rounding = kJudgeRounding * (size + mostOff) * (perimeter + size + mostOff);
  if (clip.scope.isAll() && !(std::abs(sum.value() - clip.region.area()) <= rounding)) return kAreas;
  return nullptr;
}

}  // namespace circle_voronoi
