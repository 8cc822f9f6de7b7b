// SPDX-License-Identifier: GPL-3.0-or-later
#include "crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <queue>
#include <unordered_map>

#include "at.h"
#include "circle_voronoi/cells.h"
#include "circle_voronoi/curve.h"
#include "circle_voronoi/finder.h"
#include "clip.h"
#include "far_view.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

/// How far differences of distances may be off, as a share of what they are made of: generous.
constexpr double kDistanceRounding = 0x1p-44;
/// What is nearer along the walk than this share of coordinates may be one point.
constexpr double kNearlyAtOnce = 0x1p-40;
/// The same as a share of the side.
constexpr double kNearlyOneShare = 0x1p-30;
/// What is nearer to each other than this share of where it is seen from, may be moved apart (far_view.h).
constexpr double kNearlyOnePlace = 0x1p-880;

/// A side of the region, in the direction that both cells see.
struct Line {
  Point from;  ///< the smaller of its ends, by x and then y
  Point to;
  Vector along;
  double length = 0;
  bool isForward = true;  ///< whether the region lies on the left of this direction

  Line(Point start, Point end)
      : isForward(start.x < end.x || (start.x == end.x && start.y < end.y)) {
    from = isForward ? start : end;
    to = isForward ? end : start;
    along = vectorTo(from, to);
    length = lengthOf(along);
  }

  /// From the share of the direction above to that of the walk, or back.
  double turned(double share) const { return isForward ? share : 1 - share; }

  double shareOf(Point p) const {
    const double unit = unitFor(largestOf(along));
    const Vector direction = measuredIn(unit, along);
    return dot(measuredIn(unit, vectorTo(from, p)), direction) / dot(direction, direction);
  }

  Point at(double share) const {
    if (share <= 0) return from;
    if (share >= 1) return to;
    return {from.x + share * along.x, from.y + share * along.y};
  }
};

/// Where the walk leaves a cell.
struct Exit {
  double when = 2;  ///< the share of the way along the side; beyond 1 for none
  double share = 0;
  SideIndex side = {};  ///< of the cell
  double parameter = 0;  ///< on the edge of that side
};

class Walk {
 public:
  Walk(const Diagram& diagram, const Region& region)
      : diagram_(diagram), region_(region), bounds_(region.bounds()) {
    farthest_ = std::max({std::abs(bounds_.minX), std::abs(bounds_.minY), std::abs(bounds_.maxX),
                          std::abs(bounds_.maxY)});
    for (const Circle& c : diagram.circles) farthest_ = std::max({farthest_, std::abs(c.x), std::abs(c.y)});
    for (const Vertex& v : diagram.vertices) farthest_ = std::max({farthest_, std::abs(v.x), std::abs(v.y)});
  }

  Crossings run() {
    const Finder finder(diagram_);
    for (std::size_t r = 0; r < region_.ringCount(); ++r) {
      cell_ = finder.find(region_.points()[at(region_.ringOffsets()[r])], cell_);
      walkRing(static_cast<std::int32_t>(r));
    }
    return std::move(crossings_);
  }

  /// Follows the boundary where it meets a box, and keeps crossings of edges of some cells that lie in the box.
  Crossings run(const Box& box, const std::vector<std::uint8_t>& isChosen, CircleIndex near) {
    const auto sides = region_.sidesIn(box);
    const auto offsets = region_.ringOffsets();
    for (std::size_t k = 0; k < sides.size();) {
      const auto ring = at(region_.ringOf(sides[k]));
      const std::int32_t begin = offsets[ring];
      const std::int32_t end = offsets[ring + 1];
      std::size_t last = k;
      while (last < sides.size() && sides[last] < end) ++last;
      if (last - k == at(end - begin)) {
        cell_ = nearestTo(region_.points()[at(begin)], near);
        walkRing(static_cast<std::int32_t>(ring));
      } else {
        walkParts(std::span(sides).subspan(k, last - k), begin, end, near);
      }
      k = last;
    }
    return chosen(isChosen);
  }

 private:
  Point startOf(std::int32_t side, std::int32_t begin, std::int32_t end) const {
    return region_.points()[at(side == end ? begin : side)];
  }

  /// `cell_` has the start of the ring.
  void walkRing(std::int32_t ring) {
    const std::int32_t begin = region_.ringOffsets()[at(ring)];
    const std::int32_t end = region_.ringOffsets()[at(ring) + 1];
    const auto firstCrossing = static_cast<std::int32_t>(crossings_.all.size());
    const CircleIndex first = cell_;
    clearance_ = 0;
    for (std::int32_t k = begin; k < end; ++k) walkAlong(k, startOf(k, begin, end), startOf(k + 1, begin, end));
    if (cell_ != first) closeRing(end - 1, startOf(end - 1, begin, end), startOf(end, begin, end), first);
    linkFrom(firstCrossing, firstCrossing);
    if (at(firstCrossing) == crossings_.all.size()) crossings_.rings.push_back({first, ring});
  }

  /// Walks along some sides of a ring, but not all.
  void walkParts(std::span<const RegionSideIndex> sides, std::int32_t begin, std::int32_t end, CircleIndex near) {
    // A part may go on through the end of the ring.
    std::size_t first = 0;
    if (sides.front() == begin && sides.back() == end - 1) {
      while (sides[first] == begin + static_cast<std::int32_t>(first)) ++first;
    }
    std::int32_t before = kNone;
    auto firstCrossing = static_cast<std::int32_t>(crossings_.all.size());
    for (std::size_t k = 0; k < sides.size(); ++k) {
      const std::int32_t side = sides[(first + k) % sides.size()];
      const Point start = startOf(side, begin, end);
      const bool goesOn = before != kNone && (before + 1 == end ? begin : before + 1) == side;
      if (!goesOn) {
        linkFrom(firstCrossing, kNone);
        firstCrossing = static_cast<std::int32_t>(crossings_.all.size());
        cell_ = nearestTo(start, near);
        clearance_ = 0;
      }
      walkAlong(side, start, startOf(side + 1, begin, end));
      before = side;
    }
    linkFrom(firstCrossing, kNone);
  }

  /// Links the crossings of a walk; `afterLast` follows the last of them.
  void linkFrom(std::int32_t first, std::int32_t afterLast) {
    const auto end = static_cast<std::int32_t>(crossings_.all.size());
    for (std::int32_t c = first; c < end; ++c) crossings_.next.push_back(c + 1 == end ? afterLast : c + 1);
  }

  /// The nearest circle, by steps to nearer neighbors.
  CircleIndex nearestTo(Point p, CircleIndex from) const {
    for (std::size_t steps = 0; steps < diagram_.circles.size(); ++steps) {
      CircleIndex best = from;
      for (const SideIndex side : diagram_.sides(from)) {
        const CircleIndex neighbor = diagram_.neighborOf(side);
        if (lead(diagram_, neighbor, best, p) > 0) best = neighbor;
      }
      if (best == from) break;
      from = best;
    }
    return from;
  }

  /// The crossings of edges of chosen cells. Between one where the boundary comes into such a cell and the next one there
  /// is no other.
  Crossings chosen(const std::vector<std::uint8_t>& isChosen) {
    Crossings result;
    std::vector<std::int32_t> places(crossings_.all.size(), kNone);
    const auto has = [&](CircleIndex circle) { return isChosen[at(circle)] != 0; };
    for (std::size_t c = 0; c < places.size(); ++c) {
      const Edge& edge = diagram_.edges[at(crossings_.all[c].edge)];
      if (!has(edge.left) && !has(edge.right)) continue;
      places[c] = static_cast<std::int32_t>(result.all.size());
      result.all.push_back(crossings_.all[c]);
    }
    for (std::size_t c = 0; c < places.size(); ++c) {
      if (places[c] == kNone) continue;
      const std::int32_t next = crossings_.next[c];
      result.next.push_back(next == kNone ? kNone : places[at(next)]);
    }
    for (const auto& one : crossings_.rings) {
      if (has(one.cell)) result.rings.push_back(one);
    }
    return result;
  }

  void walkAlong(RegionSideIndex side, Point start, Point end) {
    const Line line(start, end);
    if (line.length < clearance_) {
      clearance_ -= line.length;
      return;
    }
    double when = 0;
    stalled_.clear();
    isSettled_ = false;
    for (;;) {
      isBlocked_ = false;
      const Exit exit = exitFrom(line, start, end, when);
      if (isBlocked_ && exit.when > when) {
        isSettled_ = true;
        if (goBack(line, when)) continue;
      }
      if (exit.when > 1) return;
      addCrossing(side, line, exit);
      if (exit.when > when) {
        stalled_.clear();
        isSettled_ = false;
      }
      when = exit.when;
      stalled_.push_back(cell_);
      cell_ = diagram_.neighborOf(exit.side);
    }
  }

  /// Where rounding leads around a vertex from cell to cell, takes the one of them that comes next along the line.
  /// Returns whether that is another one than the cell of the walk, to which it goes back.
  bool goBack(const Line& line, double when) {
    double next = 1;
    for (const CircleIndex one : stalled_) {
      const Bisector bisector =
          circle_voronoi::bisector(diagram_.circles[at(one)], diagram_.circles[at(cell_)], diagram_.metric);
      const LineCrossing crossing(bisector, line.from, line.along);
      for (const double s : crossing.parameters()) {
        const double its = line.turned(line.shareOf(pointAt(bisector, s)));
        if (its - when > kNearlyOneShare) next = std::min(next, its);
      }
    }
    const Point ahead = line.at(line.turned((when + next) / 2));
    std::size_t best = stalled_.size();
    const auto cellAt = [&](std::size_t k) { return k < stalled_.size() ? stalled_[k] : cell_; };
    for (std::size_t k = 0; k < stalled_.size(); ++k) {
      if (lead(diagram_, cellAt(k), cellAt(best), ahead) > 0) best = k;
    }
    if (best == stalled_.size()) return false;
    cell_ = stalled_[best];
    crossings_.all.resize(crossings_.all.size() - (stalled_.size() - best));
    stalled_.resize(best);
    return true;
  }

  /// Finds where the walk next leaves its cell: where a neighbor comes to be nearer than its circle. Only the neighbors
  /// are asked, as a cell is what is nearer to its circle than to each neighbor. `clearance_` becomes how far the end
  /// of the side is from the border of the cell, at least.
  Exit exitFrom(const Line& line, Point start, Point end, double when) {
    exits_.clear();
    clearance_ = kInfinite;
    const Point here = when == 0 ? start : line.at(line.turned(when));
    for (const SideIndex side : diagram_.sides(cell_)) {
      const auto [isClear, clearance] =
          clearanceOf(diagram_.neighborOf(side), (1 - when) * line.length, here, end);
      clearance_ = std::min(clearance_, clearance);
      if (isClear) continue;
      const Exit exit = exitAcross(side, line, start, end, when);
      if (exit.when <= 1) exits_.push_back(exit);
    }
    if (exits_.empty()) return {};
    const Exit first = *std::ranges::min_element(exits_, {}, &Exit::when);
    // Several may be there at once: two circles may share several edges, which have one bisector, and at a vertex
    // rounding does not tell who comes first. The exit is across an edge that is there.
    const double farthest = largestOf({end.x, end.y}) + line.length;
    std::erase_if(exits_, [&](const Exit& exit) {
      return (exit.when - first.when) * line.length > kNearlyAtOnce * farthest;
    });
    if (exits_.size() == 1) return first;
    return *std::ranges::min_element(exits_, {}, [&](const Exit& exit) { return missBy(exit); });
  }

  struct Clearance {
    bool isClear;     ///< whether the neighbor is farther than the circle all along the rest of the side
    double distance;  ///< how far the end is from the bisector, at least
  };

  Clearance clearanceOf(CircleIndex neighbor, double way, Point start, Point end) const {
    const Circle& c = diagram_.circles[at(cell_)];
    const Circle& d = diagram_.circles[at(neighbor)];
    if (diagram_.metric == Metric::power) {
      const double apart = lengthOf(between(c, d));
      const auto gap = [&](Point p) {
        const double own = dot({p.x - c.x, p.y - c.y}, {p.x - c.x, p.y - c.y});
        const double other = dot({p.x - d.x, p.y - d.y}, {p.x - d.x, p.y - d.y});
        const double error = kDistanceRounding * (own + other + c.r * c.r + d.r * d.r);
        return ((other - d.r * d.r) - (own - c.r * c.r) - error) / (2 * apart);
      };
      const double atEnd = gap(end);
      return {gap(start) > 0 && atEnd > 0, atEnd};
    }
    const double difference = diagram_.metric == Metric::circles ? c.r - d.r : 0;
    const auto gap = [&](Point p) {
      const double own = std::sqrt(dot({p.x - c.x, p.y - c.y}, {p.x - c.x, p.y - c.y}));
      const double other = std::sqrt(dot({p.x - d.x, p.y - d.y}, {p.x - d.x, p.y - d.y}));
      return (other - own) + difference - kDistanceRounding * (own + other + std::abs(difference));
    };
    // Distances change by no more than the way, and those from points are compared in half-planes.
    const double atStart = gap(start);
    const double atEnd = gap(end);
    const bool isClear = difference == 0 ? atStart > 0 && atEnd > 0 : atStart + atEnd > 2 * way;
    return {isClear, atEnd / 2};
  }

  /// The bisector of the circles of an edge, the one of smaller index on the left. All edges of the two have this one.
  Bisector bisectorOf(EdgeIndex edge) const {
    const Edge& ends = diagram_.edges[at(edge)];
    const auto [left, right] = std::minmax({std::int32_t{ends.left}, std::int32_t{ends.right}});
    const Bisector bisector =
        circle_voronoi::bisector(diagram_.circles[at(left)], diagram_.circles[at(right)], diagram_.metric);
    const double size = (std::abs(bisector.a) + bisector.b) * bisector.unit;
    if (size > kNearlyOnePlace * farthest_) return bisector;
    const EdgeCurve curve = curveIn(diagram_, bounds_, edge);
    return isTurned(edge) ? reversed(curve).bisector : curve.bisector;
  }
  bool isTurned(EdgeIndex edge) const { return diagram_.edges[at(edge)].left > diagram_.edges[at(edge)].right; }

  /// Where the neighbor across a side of the cell comes to be nearer, no earlier than `when`.
  Exit exitAcross(SideIndex side, const Line& line, Point start, Point end, double when) {
    const EdgeIndex edge = Diagram::edgeOf(side);
    const CircleIndex neighbor = diagram_.neighborOf(side);
    const Bisector bisector = bisectorOf(edge);
    const LineCrossing crossing(bisector, line.from, line.along);
    struct Event {
      double when;
      double share;
      double parameter;
      bool isExit;
    };
    std::array<Event, 2> events{};
    std::size_t count = 0;
    for (std::size_t k = 0; k < crossing.parameters().size(); ++k) {
      const double s = crossing.parameters()[k];
      const double share = line.shareOf(pointAt(bisector, s));
      if (std::isnan(share)) continue;
      // Where the bisector goes to the right of the line, the line goes from its right circle to its left one.
      const bool goesToLeft = crossing.goesRight(k) == line.isForward;
      events[count++] = {line.turned(share), share, s, goesToLeft == (neighbor < cell_)};
    }
    if (count == 2 && events[0].when > events[1].when) std::swap(events[0], events[1]);

    const auto exitAt = [&](double itsWhen, double share, double parameter) {
      return Exit{itsWhen, share, side, isTurned(edge) ? 1 / parameter : parameter};
    };
    const bool canStall = std::ranges::find(stalled_, neighbor) == stalled_.end();
    bool isBeaten = count > 0 ? !events[0].isExit : isFarther(neighbor, start, end);
    for (std::size_t k = 0; k < count && events[k].when <= when; ++k) isBeaten = events[k].isExit;
    isBlocked_ = isBlocked_ || (isBeaten && !canStall && !isSettled_);
    if (isBeaten && canStall && !isSettled_) {
      const double share = line.turned(when);
      return exitAt(when, share, parameterAt(bisector, line.at(share)));
    }
    for (std::size_t k = 0; k < count; ++k) {
      const auto& event = events[k];
      if (event.isExit && event.when > when && event.when <= 1) {
        return exitAt(event.when, event.share, event.parameter);
      }
    }
    return {};
  }

  /// Whether the circle of the cell is farther than a neighbor from a line that their bisector does not cross.
  bool isFarther(CircleIndex neighbor, Point start, Point end) const {
    const double atStart = lead(diagram_, cell_, neighbor, start);
    const double atEnd = lead(diagram_, cell_, neighbor, end);
    return (std::abs(atStart) > std::abs(atEnd) ? atStart : atEnd) < 0;
  }

  /// How far an exit is beyond the ends of its edge, as a ratio of parameters; 1 on the edge.
  double missBy(const Exit& exit) const {
    const EdgeCurve curve = curveIn(diagram_, bounds_, Diagram::edgeOf(exit.side));
    return std::max({1.0, curve.from / exit.parameter, exit.parameter / curve.to});
  }

  void addCrossing(RegionSideIndex side, const Line& line, const Exit& exit) {
    const EdgeIndex edge = Diagram::edgeOf(exit.side);
    const EdgeCurve curve = curveIn(diagram_, bounds_, edge);
    Crossing crossing;
    crossing.edge = edge;
    crossing.side = side;
    crossing.share = std::clamp(exit.share, 0.0, 1.0);
    crossing.point = line.at(crossing.share);
    crossing.parameter = std::clamp(exit.parameter, curve.from, curve.to);
    crossing.isEntry = exit.side % 2 == 0;
    crossings_.all.push_back(crossing);
  }

  /// Goes to the first cell of a ring where rounding has led to another one there: across edges that are near.
  void closeRing(RegionSideIndex side, Point start, Point end, CircleIndex first) {
    struct Step {
      double way;  ///< how far the edges are from the point, together
      SideIndex across;
      CircleIndex cell;
      bool operator>(const Step& other) const { return way > other.way; }
    };
    std::unordered_map<std::int32_t, SideIndex> cameAcross;
    std::priority_queue<Step, std::vector<Step>, std::greater<>> pending;
    pending.push({0, kNone, cell_});
    while (!cameAcross.contains(first)) {
      const Step step = pending.top();
      pending.pop();
      if (!cameAcross.emplace(step.cell, step.across).second) continue;
      for (const SideIndex across : diagram_.sides(step.cell)) {
        const CircleIndex neighbor = diagram_.neighborOf(across);
        if (cameAcross.contains(neighbor)) continue;
        const EdgeCurve curve = curveIn(diagram_, bounds_, Diagram::edgeOf(across));
        const double s = std::clamp(parameterAt(curve.bisector, end), curve.from, curve.to);
        pending.push({step.way + lengthOf(vectorTo(end, pointAt(curve.bisector, s))), across, neighbor});
      }
    }
    std::vector<SideIndex> path;
    for (CircleIndex cell = first; cell != cell_; cell = diagram_.circleOf(path.back())) {
      path.push_back(cameAcross[cell]);
    }
    const Line line(start, end);
    for (; !path.empty(); path.pop_back()) {
      const EdgeCurve curve = curveIn(diagram_, bounds_, Diagram::edgeOf(path.back()));
      addCrossing(side, line, {1, line.turned(1), path.back(), parameterAt(curve.bisector, end)});
    }
    cell_ = first;
  }

  const Diagram& diagram_;
  const Region& region_;
  Box bounds_;
  double farthest_ = 0;  ///< the largest coordinate
  CircleIndex cell_;     ///< where the walk is
  double clearance_ = 0;
  std::vector<Exit> exits_;           ///< those of the cell
  std::vector<CircleIndex> stalled_;  ///< the cells that the walk has left at the point where it is
  bool isBlocked_ = false;  ///< whether one of these is nearer
  bool isSettled_ = false;  ///< whether the walk is to stay in its cell at the point where it is
  Crossings crossings_;
};

}  // namespace

EdgeCurve curveIn(const Diagram& diagram, const Box& bounds, EdgeIndex edge) {
  const EdgeCurve curve = edgeCurve(diagram, edge);
  const Point origin = curve.bisector.origin;
  return seenFrom(curve, std::max({std::abs(bounds.minX - origin.x), std::abs(bounds.maxX - origin.x),
                                   std::abs(bounds.minY - origin.y), std::abs(bounds.maxY - origin.y)}));
}

Crossings crossingsOf(const Diagram& diagram, const Region& region) { return Walk(diagram, region).run(); }

Crossings crossingsOf(const Diagram& diagram, const Region& region, std::span<const CircleIndex> circles) {
  std::vector<std::uint8_t> isChosen(diagram.circles.size(), 0);
  Box box = {kInfinite, kInfinite, -kInfinite, -kInfinite};
  const auto include = [&](Point p) {
    box = {std::min(box.minX, p.x), std::min(box.minY, p.y), std::max(box.maxX, p.x), std::max(box.maxY, p.y)};
  };
  CircleIndex near;
  const Box bounds = region.bounds();
  for (const CircleIndex circle : circles) {
    if (!diagram.hasCell(circle)) continue;
    isChosen[at(circle)] = 1;
    near = circle;
    bool isBounded = !diagram.sides(circle).empty();
    for (const SideIndex side : diagram.sides(circle)) {
      const EdgeCurve curve = edgeCurve(diagram, Diagram::edgeOf(side));
      isBounded = isBounded && curve.isBounded();
      if (!curve.isBounded()) break;
      include(curve.start);
      include(curve.end);
      if (!curve.isStraight()) include(rationalBezier(curve).control);
    }
    if (isBounded) continue;
    include({bounds.minX, bounds.minY});
    include({bounds.maxX, bounds.maxY});
  }
  if (near == kNone) return {};
  // More than rounding can move what lies in the cells.
  const double margin = kNearlyAtOnce * std::max({std::abs(box.minX), std::abs(box.maxX), std::abs(box.minY),
                                                  std::abs(box.maxY)});
  box = {box.minX - margin, box.minY - margin, box.maxX + margin, box.maxY + margin};
  return Walk(diagram, region).run(box, isChosen, near);
}

}  // namespace circle_voronoi
