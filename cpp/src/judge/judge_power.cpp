// SPDX-License-Identifier: GPL-3.0-or-later
#include "judge_power.h"

#include <utility>
#include <vector>

#include "at.h"
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
        return {dual_.origin[at(h)] == dual_.target(h) ? Flaw::badIndex : Flaw::adjacency, kNone, h / 3, h};
      }
    }
    if (siteCount < 2) return {};
    int finiteCount = 0;
    for (int face = 0; face < dual_.faceCount(); ++face) {
      if (!dual_.isFinite(face)) continue;
      ++finiteCount;
      const auto [a, b, c] = cornersOf(dual_, 3 * face);
      if (orientation(sites_[at(a)].p, sites_[at(b)].p, sites_[at(c)].p) <= 0)
        return {Flaw::vertexWithoutDisc, kNone, face};
    }
    for (int h = 0; h < dual_.halfEdgeCount(); ++h) {
      const int t = dual_.twin[at(h)];
      if (t < h || !dual_.isFinite(h / 3) || !dual_.isFinite(t / 3)) continue;
      const auto [a, b, c] = cornersOf(dual_, h);
      const WeightedPoint& opposite = sites_[at(dual_.origin[at(Dual::previous(t))])];
      if (powerTest(sites_[at(a)], sites_[at(b)], sites_[at(c)], opposite) > 0)
        return {Flaw::edgeOutOfOrder, kNone, h / 3, h};
    }
    return {isHullRight(finiteCount) ? Flaw::none : Flaw::hullNotClosed};
  }

 private:
  /// Goes along the hull, counter-clockwise. Where it turns back, all sites lie on a line that ends there.
  bool isHullRight(int finiteCount) const {
    int first = 0;
    while (first < dual_.halfEdgeCount() && isFinite(dual_.origin[at(first)])) ++first;
    if (first == dual_.halfEdgeCount()) return false;
    int minima = 0;
    int infiniteCount = 0;
    int h = first;
    do {
      // The corners of the face (infinity, v, before), and of the next one, (infinity, after, v).
      const int v = dual_.target(h);
      const int before = dual_.origin[at(Dual::previous(h))];
      const int after = dual_.target(dual_.aroundClockwise(h));
      if (!isFinite(v) || !isFinite(before) || !isFinite(after)) return false;
      const bool comesUp = isBefore(sites_[at(before)].p, sites_[at(v)].p);
      const bool goesUp = isBefore(sites_[at(v)].p, sites_[at(after)].p);
      if (before == after) {
        if (finiteCount > 0) return false;
      } else if (const int turn = orientation(sites_[at(before)].p, sites_[at(v)].p, sites_[at(after)].p); turn == 0) {
        if (comesUp != goesUp || powerTest(sites_[at(before)], sites_[at(after)], sites_[at(v)]) < 0) return false;
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
      if (orientation(sites[at(dual.origin[at(h)])].p, sites[at(dual.target(h))].p, place) < 0)
        next = dual.twin[at(h)] / 3;
    }
    if (next == kNone) return face;
    face = next;
  }
  return kNone;
}

int edgeAround(std::span<const WeightedPoint> sites, const Dual& dual, Point place, int start) {
  int h = start;
  if (orientation(sites[at(dual.origin[at(h)])].p, sites[at(dual.target(h))].p, place) != 0) return kNone;
  for (int step = 0; step <= dual.halfEdgeCount(); ++step) {
    const Point from = sites[at(dual.origin[at(h)])].p;
    const Point to = sites[at(dual.target(h))].p;
    if (from == place || to == place || isBefore(from, place) != isBefore(to, place)) return h;
    if (isBefore(from, to) != isBefore(to, place)) {
      h = dual.twin[at(h)];
      continue;
    }
    // The edge after this one around infinity; beyond an end it is the same edge again.
    const int next = Dual::next(dual.twin[at(Dual::next(h))]);
    if (next == dual.twin[at(h)]) return kNone;
    h = next;
  }
  return kNone;
}

Verdict judgeHiddenPoints(std::span<const WeightedPoint> sites, const Dual& dual, std::span<const HiddenPoint> points) {
  if (points.empty()) return {};
  std::vector<int> finiteFaceAt(sites.size(), kNone);
  std::vector<int> edgeAt(sites.size(), kNone);
  for (int h = 0; h < dual.halfEdgeCount(); ++h) {
    if (!isFinite(dual.origin[at(h)]) || !isFinite(dual.target(h))) continue;
    edgeAt[at(dual.origin[at(h)])] = h;
    if (dual.isFinite(h / 3)) finiteFaceAt[at(dual.origin[at(h)])] = h / 3;
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    const WeightedPoint& point = points[k].point;
    const int beside = points[k].beside;
    const bool isHidden = [&] {
      if (beside < 0 || static_cast<std::size_t>(beside) >= sites.size()) return false;
      if (edgeAt[at(beside)] == kNone) {
        const WeightedPoint& only = sites[at(beside)];
        return point.p == only.p &&
               std::pair(point.weight.value, point.weight.rest) <= std::pair(only.weight.value, only.weight.rest);
      }
      if (finiteFaceAt[at(beside)] == kNone) {
        const int h = edgeAround(sites, dual, point.p, edgeAt[at(beside)]);
        return h != kNone && powerTest(sites[at(dual.origin[at(h)])], sites[at(dual.target(h))], point) <= 0;
      }
      const int face = faceAround(sites, dual, point.p, finiteFaceAt[at(beside)]);
      if (face == kNone || !dual.isFinite(face)) return false;
      const auto [a, b, c] = cornersOf(dual, 3 * face);
      return powerTest(sites[at(a)], sites[at(b)], sites[at(c)], point) <= 0;
    }();
    if (!isHidden) return {Flaw::hiddenWithoutHider, static_cast<std::int32_t>(k)};
  }
  return {};
}

}  // namespace circle_voronoi
