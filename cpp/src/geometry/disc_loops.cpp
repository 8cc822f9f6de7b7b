// SPDX-License-Identifier: GPL-3.0-or-later
#include "disc_loops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "vectors.h"

namespace circle_voronoi {
namespace {

/// A full turn, of pseudo-angles.
constexpr double kWholeRim = 4;

}  // namespace

void DiscLoops::beginLoop(bool isHole, bool isInside) {
  isHole_ = isHole;
  startsInside_ = isInside;
  isCut_ = false;
  firstChain_ = chains_.size();
  pieces_.clear();
  before_.clear();
}

void DiscLoops::enter(const RimPoint& point) {
  isCut_ = true;
  entry_ = point;
  pieces_.clear();
}

void DiscLoops::leave(const RimPoint& point) {
  if (startsInside_ && !isCut_) {
    isCut_ = true;
    before_ = std::exchange(pieces_, {});
    firstExit_ = point;
    return;
  }
  chains_.push_back({std::exchange(pieces_, {}), entry_, point});
}

void DiscLoops::endLoop() {
  if (!startsInside_) return;
  if (!isCut_) {
    if (!pieces_.empty()) (isHole_ ? holes_ : closed_).push_back(std::exchange(pieces_, {}));
    return;
  }
  // The chain that goes on through the start of the loop.
  std::ranges::move(before_, std::back_inserter(pieces_));
  chains_.push_back({std::exchange(pieces_, {}), entry_, firstExit_});
}

Point DiscLoops::center() const {
  const Circle c = signs_.circle(cell_);
  return {c.x, c.y};
}

Point DiscLoops::pointAt(double place) const {
  constexpr std::array<Vector, 4> kAxes = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  const Vector axis = kAxes[static_cast<std::size_t>(place) % kAxes.size()];
  const double r = signs_.radius(cell_);
  return {center().x + r * axis.x, center().y + r * axis.y};
}

/// Adds arcs of a quarter at most. Arcs that are points up to rounding are left out.
void DiscLoops::addSteps(std::vector<OutlinePiece>& loop, Point start, Point end, double from, double to) const {
  const auto add = [&](Point p) {
    if (start != p) loop.push_back({segment(start, p), kNone, kNone, signs_.radius(cell_)});
    start = p;
  };
  for (double quarter = std::floor(from) + 1; quarter < to; ++quarter) add(pointAt(quarter));
  add(end);
}

void DiscLoops::addArc(std::vector<OutlinePiece>& loop, const RimPoint& from, const RimPoint& to,
                       bool isWrapped) const {
  // The place in the half in which the point lies exactly.
  const auto placeOf = [&](const RimPoint& p) {
    if (signs_.isUpper(cell_, p)) return p.place > 3 ? 0 : std::min(p.place, 2.0);
    return p.place < 1 ? kWholeRim : std::max(p.place, 2.0);
  };
  const double begin = placeOf(from);
  const double end = placeOf(to) + (isWrapped ? kWholeRim : 0);
  addSteps(loop, from.point, to.point, begin, std::max(begin, end));
}

void DiscLoops::join(LoopsWithin& result) {
  struct Event {
    std::size_t chain;
    bool isEntry;
  };
  std::vector<Event> events;
  for (std::size_t c = 0; c < chains_.size(); ++c) events.insert(events.end(), {{c, true}, {c, false}});
  const auto pointOf = [&](const Event& event) -> const RimPoint& {
    return event.isEntry ? chains_[event.chain].entry : chains_[event.chain].exit;
  };
  std::ranges::stable_sort(
      events, [&](const Event& a, const Event& b) { return signs_.isBefore(cell_, pointOf(a), pointOf(b)); });
  std::vector<std::size_t> next(chains_.size());
  for (std::size_t k = 0; k < events.size(); ++k) {
    const bool isLast = k + 1 == events.size();
    const Event& after = events[isLast ? 0 : k + 1];
    if (events[k].isEntry == after.isEntry) {
      result.isSound = false;
      return;
    }
    if (events[k].isEntry) continue;
    next[events[k].chain] = after.chain;
    addArc(chains_[events[k].chain].pieces, pointOf(events[k]), pointOf(after), isLast);
  }
  std::vector<std::uint8_t> isDone(chains_.size(), 0);
  for (std::size_t i = 0; i < chains_.size(); ++i) {
    std::vector<OutlinePiece> loop;
    for (std::size_t j = i; isDone[j] == 0; j = next[j]) {
      isDone[j] = 1;
      std::ranges::move(chains_[j].pieces, std::back_inserter(loop));
    }
    if (!loop.empty()) result.outline.push_back(std::move(loop));
  }
}

LoopsWithin DiscLoops::finish(bool isWhole) {
  LoopsWithin result;
  if (!chains_.empty()) {
    join(result);
  } else if (isWhole) {
    std::vector<OutlinePiece> rim;
    addSteps(rim, pointAt(0), pointAt(0), 0, kWholeRim);
    if (!rim.empty()) result.outline.push_back(std::move(rim));
  }
  std::ranges::move(closed_, std::back_inserter(result.outline));
  result.isHole.assign(result.outline.size(), 0);
  if (result.outline.empty()) return result;
  std::ranges::move(holes_, std::back_inserter(result.outline));
  result.isHole.resize(result.outline.size(), 1);
  return result;
}

void addArcWithin(DiscLoops& loops, const DistanceSigns& signs, const Diagram& diagram, SideIndex side,
                  const EdgeCurve& curve, const ArcEnd& start, const ArcEnd& end) {
  auto arc = arcWithin(signs, diagram.edges[static_cast<std::size_t>(Diagram::edgeOf(side))], curve, start, end);
  if (!arc) return;
  if (side % 2 != 0) {
    arc->curve = reversed(arc->curve);
    std::swap(arc->isCutFrom, arc->isCutTo);
  }
  const auto rimPoint = [&](bool isAhead) {
    RimPoint point = signs.rimPoint(diagram.circleOf(side), RimLine::ofEdge(diagram.neighborOf(side)), isAhead);
    point.side = side;
    point.point = isAhead ? arc->curve.end : arc->curve.start;
    return point;
  };
  if (arc->isCutFrom) loops.enter(rimPoint(false));
  if (!arc->isPoint()) loops.add({arc->curve, side, diagram.neighborOf(side)});
  if (arc->isCutTo) loops.leave(rimPoint(true));
}

}  // namespace circle_voronoi
