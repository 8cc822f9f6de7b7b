// SPDX-License-Identifier: GPL-3.0-or-later
#include "judge_clip.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "at.h"
#include "compensated_sum.h"
#include "shifted_signs.h"

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
  explicit Judge(const ClipRecord& clip) : clip_(clip), isChosen_(clip.diagram.circles.size(), clip.circles ? 0 : 1) {
    if (!clip.circles) return;
    for (const CircleIndex circle : *clip.circles) isChosen_[at(circle)] = 1;
  }

  const char* fault() const {
    if (!haveLevels()) return kLevels;
    if (!haveArcs()) return kArcs;
    if (!hasBoundary()) return kBoundary;
    return nullptr;
  }

 private:
  bool isCrossing(std::int32_t crossing) const { return crossing >= 0 && at(crossing) < clip_.crossings.all.size(); }
  bool isInside(VertexIndex vertex) const { return vertex != kNone && clip_.levels[at(vertex)] == 1; }
  bool isOfChosen(const Edge& edge) const { return isChosen_[at(edge.left)] != 0 || isChosen_[at(edge.right)] != 0; }

  bool haveLevels() const {
    if (clip_.levels.size() != clip_.diagram.vertices.size()) return false;
    if (std::ranges::any_of(clip_.levels, [](std::int32_t level) { return level != 0 && level != 1; })) return false;
    std::vector<std::int32_t> rise(clip_.diagram.edges.size(), 0);
    for (const Crossing& crossing : clip_.crossings.all) {
      if (crossing.edge < 0 || at(crossing.edge) >= rise.size()) return false;
      rise[at(crossing.edge)] += crossing.isEntry ? 1 : -1;
    }
    for (std::size_t e = 0; e < rise.size(); ++e) {
      const Edge& edge = clip_.diagram.edges[e];
      const int change = (isInside(edge.end) ? 1 : 0) - (isInside(edge.start) ? 1 : 0);
      if (isOfChosen(edge) && rise[e] != change) return false;
    }
    return true;
  }

  bool haveArcs() const {
    // The number of arcs that end at each crossing, and for each edge the number of arcs that begin and end at
    // vertices.
    std::vector<std::int32_t> ends(clip_.crossings.all.size(), 0);
    std::vector<std::int32_t> atVertices(clip_.diagram.edges.size(), 0);
    std::vector<std::uint8_t> isCrossed(clip_.diagram.edges.size(), 0);
    const auto use = [&](std::int32_t crossing, EdgeIndex edge, bool isStart) {
      if (!isCrossing(crossing)) return false;
      const Crossing& its = clip_.crossings.all[at(crossing)];
      ++ends[at(crossing)];
      return its.edge == std::int32_t{edge} && its.isEntry == isStart;
    };
    for (const Crossing& crossing : clip_.crossings.all) isCrossed[at(crossing.edge)] = 1;
    for (const Arc& arc : clip_.arcs) {
      if (arc.edge < 0 || at(arc.edge) >= atVertices.size()) return false;
      const Edge& edge = clip_.diagram.edges[at(arc.edge)];
      if (arc.start != kNone && !use(arc.start, arc.edge, true)) return false;
      if (arc.end != kNone && !use(arc.end, arc.edge, false)) return false;
      if (arc.start == kNone && !isInside(edge.start)) return false;
      if (arc.end == kNone && !isInside(edge.end)) return false;
      atVertices[at(arc.edge)] += (arc.start == kNone ? 1 : 0) + (arc.end == kNone ? 1 : 0);
    }
    if (std::ranges::any_of(ends, [](std::int32_t count) { return count != 1; })) return false;
    for (std::size_t e = 0; e < atVertices.size(); ++e) {
      const Edge& edge = clip_.diagram.edges[e];
      const int inside = (isInside(edge.start) ? 1 : 0) + (isInside(edge.end) ? 1 : 0);
      if (isCrossed[e] != 0 && isOfChosen(edge) && atVertices[e] != inside) return false;
    }
    return true;
  }

  bool hasBoundary() const {
    const auto& [all, next, rings] = clip_.crossings;
    if (next.size() != all.size()) return false;
    const auto cellOf = [&](const Crossing& crossing, bool isAfter) {
      const Edge& edge = clip_.diagram.edges[at(crossing.edge)];
      return crossing.isEntry == isAfter ? edge.right : edge.left;
    };
    std::vector<std::uint8_t> isEnd(all.size(), 0);
    std::vector<std::uint8_t> isRingThere(clip_.region.ringCount(), 0);
    for (std::size_t c = 0; c < all.size(); ++c) {
      const std::int32_t side = all[c].side;
      if (side < 0 || at(side) >= clip_.region.sideCount() || !(all[c].share >= 0 && all[c].share <= 1)) return false;
      const auto ring = at(clip_.region.ringOf(side));
      isRingThere[ring] = 1;
      const CircleIndex cell = cellOf(all[c], true);
      if (isChosen_[at(cell)] == 0) continue;
      if (!isCrossing(next[c]) || isEnd[at(next[c])] != 0) return false;
      isEnd[at(next[c])] = 1;
      const Crossing& to = all[at(next[c])];
      if (cellOf(to, false) != cell || at(clip_.region.ringOf(to.side)) != ring) return false;
    }
    for (std::size_t c = 0; c < all.size(); ++c) {
      if (isChosen_[at(cellOf(all[c], false))] != 0 && isEnd[c] == 0) return false;
    }
    for (const auto& [cell, ring] : rings) {
      if (ring < 0 || at(ring) >= isRingThere.size() || isRingThere[at(ring)] != 0) return false;
      if (!clip_.diagram.hasCell(cell)) return false;
      isRingThere[at(ring)] = 1;
    }
    return clip_.circles || clip_.diagram.hull.empty() ||
           std::ranges::all_of(isRingThere, [](std::uint8_t isThere) { return isThere != 0; });
  }

  const ClipRecord& clip_;
  std::vector<std::uint8_t> isChosen_;
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
    if (clip.levels[v] == 1) mostOff = std::max(mostOff, signs.errorOf(static_cast<std::int32_t>(v)));
  }
  const double perimeter = clip.region.perimeter();
  CompensatedSum sum;
  for (std::size_t i = 0; i < moments.moments.size(); ++i) {
    const double area = moments.area(i);
    if (!(area >= -mostOff * (perimeter + size))) return kAreas;
    sum += area;
  }
  // Both cells of an edge see its ends at the same places, however far these are off.
  const double rounding = kJudgeRounding * (size + mostOff) * (perimeter + size + mostOff);
  if (!clip.circles && !(std::abs(sum.value() - clip.region.area()) <= rounding)) return kAreas;
  return nullptr;
}

}  // namespace circle_voronoi
