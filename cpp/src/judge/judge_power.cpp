// SPDX-License-Identifier: GPL-3.0-or-later
#include "judge_power.h"

#include <utility>
#include <vector>

#include "in_circle.h"
#include "vectors.h"

namespace circle_voronoi {
namespace {

class PowerJudge {
 public:
  PowerJudge(std::span<const WeightedPoint> sites, const Dual& dual) : sites_(sites), dual_(dual) {}

  Verdict run() {
    const auto siteCount = static_cast<int>(sites_.size());
    if (dual_.faceCount() != (siteCount < 2 ? 0 : 2 * siteCount - 2)) return {Flaw::eulerCount};
    for (int h = 0; h < dual_.halfEdgeCount(); ++h) {
      if (!dual_.fits(h)) {
        return {dual_.origin[h] == dual_.target(h) ? Flaw::badIndex : Flaw::adjacency, kNone, h / 3, h};
      }
    }
    if (siteCount < 2) return {};
    int finiteCount = 0;
    for (int face = 0; face < dual_.faceCount(); ++face) {
      if (!dual_.isFinite(face)) continue;
      ++finiteCount;
      const auto [a, b, c] = cornersOf(dual_, 3 * face);
      if (orientation(sites_[a].p, sites_[b].p, sites_[c].p) <= 0) return {Flaw::vertexWithoutDisc, kNone, face};
    }
    for (int h = 0; h < dual_.halfEdgeCount(); ++h) {
      const int t = dual_.twin[h];
      if (t < h || !dual_.isFinite(h / 3) || !dual_.isFinite(t / 3)) continue;
      const auto [a, b, c] = cornersOf(dual_, h);
      const WeightedPoint& opposite = sites_[dual_.origin[Dual::previous(t)]];
      if (powerTest(sites_[a], sites_[b], sites_[c], opposite) > 0) return {Flaw::edgeOutOfOrder, kNone, h / 3, h};
    }
    return {isHullRight(finiteCount) ? Flaw::none : Flaw::hullNotClosed};
  }

 private:
  /// Goes along the hull, counter-clockwise. Where it turns back, all sites lie on a line that ends there.
  bool isHullRight(int finiteCount) const {
    int first = 0;
    while (first < dual_.halfEdgeCount() && isFinite(dual_.origin[first])) ++first;
    if (first == dual_.halfEdgeCount()) return false;
    int minima = 0;
    int infiniteCount = 0;
    int h = first;
    do {
      // The corners of the face (infinity, v, before), and of the next one, (infinity, after, v).
      const int v = dual_.target(h);
      const int before = dual_.origin[Dual::previous(h)];
      const int after = dual_.target(dual_.aroundClockwise(h));
      if (!isFinite(v) || !isFinite(before) || !isFinite(after)) return false;
      const bool comesUp = isBefore(sites_[before].p, sites_[v].p);
      const bool goesUp = isBefore(sites_[v].p, sites_[after].p);
      if (before == after) {
        if (finiteCount > 0) return false;
      } else if (const int turn = orientation(sites_[before].p, sites_[v].p, sites_[after].p); turn == 0) {
        if (comesUp != goesUp || powerTest(sites_[before], sites_[after], sites_[v]) < 0) return false;
      } else if (turn < 0 || finiteCount == 0) {
        return false;
      }
      minima += !comesUp && goesUp ? 1 : 0;
      h = dual_.aroundClockwise(h);
      ++infiniteCount;
    } while (h != first && infiniteCount <= dual_.faceCount());
    return minima == 1 && finiteCount + infiniteCount == dual_.faceCount();
  }

  std::span<const WeightedPoint> sites_;
  const Dual& dual_;
};

}  // namespace

Verdict judgePower(std::span<const WeightedPoint> sites, const Dual& dual) { return PowerJudge(sites, dual).run(); }

int faceAround(std::span<const WeightedPoint> sites, const Dual& dual, Point place, int start) {
  int face = start;
  for (int step = 0; step <= dual.faceCount(); ++step) {
    if (!dual.isFinite(face)) return face;
    int next = kNone;
    for (int h = 3 * face; h < 3 * face + 3 && next == kNone; ++h) {
      if (orientation(sites[dual.origin[h]].p, sites[dual.target(h)].p, place) < 0) next = dual.twin[h] / 3;
    }
    if (next == kNone) return face;
    face = next;
  }
  return kNone;
}

int edgeAround(std::span<const WeightedPoint> sites, const Dual& dual, Point place, int start) {
  int h = start;
  if (orientation(sites[dual.origin[h]].p, sites[dual.target(h)].p, place) != 0) return kNone;
  for (int step = 0; step <= dual.halfEdgeCount(); ++step) {
    const Point from = sites[dual.origin[h]].p;
    const Point to = sites[dual.target(h)].p;
    if (from == place || to == place || isBefore(from, place) != isBefore(to, place)) return h;
    if (isBefore(from, to) != isBefore(to, place)) {
      h = dual.twin[h];
      continue;
    }
    // The edge after this one around infinity; beyond an end it is the same edge again.
    const int next = Dual::next(dual.twin[Dual::next(h)]);
    if (next == dual.twin[h]) return kNone;
    h = next;
  }
  return kNone;
}

Verdict judgeHiddenPoints(std::span<const WeightedPoint> sites, const Dual& dual, std::span<const HiddenPoint> points) {
  if (points.empty()) return {};
  std::vector<int> finiteFaceAt(sites.size(), kNone);
  std::vector<int> edgeAt(sites.size(), kNone);
  for (int h = 0; h < dual.halfEdgeCount(); ++h) {
    if (!isFinite(dual.origin[h]) || !isFinite(dual.target(h))) continue;
    edgeAt[dual.origin[h]] = h;
    if (dual.isFinite(h / 3)) finiteFaceAt[dual.origin[h]] = h / 3;
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    const WeightedPoint& point = points[k].point;
    const int beside = points[k].beside;
    const bool isHidden = [&] {
      if (beside < 0 || static_cast<std::size_t>(beside) >= sites.size()) return false;
      if (edgeAt[beside] == kNone) {
        const WeightedPoint& only = sites[beside];
        return point.p == only.p &&
               std::pair(point.weight.value, point.weight.rest) <= std::pair(only.weight.value, only.weight.rest);
      }
      if (finiteFaceAt[beside] == kNone) {
        const int h = edgeAround(sites, dual, point.p, edgeAt[beside]);
        return h != kNone && powerTest(sites[dual.origin[h]], sites[dual.target(h)], point) <= 0;
      }
      const int face = faceAround(sites, dual, point.p, finiteFaceAt[beside]);
      if (face == kNone || !dual.isFinite(face)) return false;
      const auto [a, b, c] = cornersOf(dual, 3 * face);
      return powerTest(sites[a], sites[b], sites[c], point) <= 0;
    }();
    if (!isHidden) return {Flaw::hiddenWithoutHider, static_cast<std::int32_t>(k)};
  }
  return {};
}

}  // namespace circle_voronoi
