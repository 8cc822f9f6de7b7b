// SPDX-License-Identifier: GPL-3.0-or-later
#include "part_within.h"

#include <algorithm>
#include <iterator>
#include <numbers>
#include <utility>

#include "at.h"
#include "in_circle.h"
#include "nesting.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

/// Points nearer than this share of the distance are within it, whatever rounding does.
constexpr double kCertainlyWithin = 1 - 0x1p-30;

SideCrossing sideCrossing(const ClipParts& parts, std::int32_t crossing) {
  const Crossing& its = parts.crossings.all[at(crossing)];
  const Edge& edge = parts.diagram.edges[at(its.edge)];
  const auto [before, after] = its.isEntry ? std::pair(edge.left, edge.right) : std::pair(edge.right, edge.left);
  return {parts.pointOf(its.side), parts.pointOf(parts.sideAfter(its.side)), before, after, its.point};
}

ArcEnd arcEnd(const ClipParts& parts, std::int32_t crossing, VertexIndex vertex) {
  if (crossing == kNone) return {vertex};
  return {kNone, sideCrossing(parts, crossing)};
}

/// Cuts the loops of a cell in the region at the rim of its disc.
class LoopCutter {
 public:
  LoopCutter(const ClipParts& parts, CircleIndex cell)
      : parts_(parts), cell_(cell), signs_(parts.diagram, *parts.maxDistance), cut_(signs_, cell) {}

  LoopsWithin run(const Loops& loops) {
    if (!signs_.hasDisc(cell_)) return {};
    for (std::size_t k = 0; k < loops.isHole.size(); ++k) {
      collectSteps(loops.loop(k));
      addLoop(loops.isHole[k] != 0);
    }
    return cut_.finish(cut_.isRimClear() && isRimInside());
  }

 private:
  /// A step along a loop: a side of the cell or a part of it, or a part of a side of the region. It begins at a vertex,
  /// a crossing, or a corner, which is the start of the side of the region.
  struct Step {
    std::int32_t crossing = kNone;  ///< where it begins; kNone for a vertex or a corner
    SideIndex side = {};
    std::int32_t arc = kNone;  ///< the arc of the side, or kNone for a whole edge
    RegionSideIndex regionSide = {};

    bool isOnEdge() const { return side != kNone; }
  };

  Arc arcOf(const Step& step) const {
    return step.arc == kNone ? Arc{Diagram::edgeOf(step.side)} : parts_.arcs.all()[at(step.arc)];
  }

  /// Steps of length zero up to rounding count, though loops leave them out.
  void collectSteps(std::span<const LoopPiece> loop) {
    steps_.clear();
    const bool hasEdges = std::ranges::any_of(loop, [](const LoopPiece& piece) { return piece.side != kNone; });
    if (!hasEdges) {
      for (const LoopPiece& piece : loop) steps_.push_back({kNone, {}, kNone, piece.regionSide});
      return;
    }
    for (const LoopPiece& piece : loop) {
      if (piece.side == kNone) continue;
      Step step = {kNone, piece.side, piece.arc};
      const Arc arc = arcOf(step);
      const bool isAlong = piece.side % 2 == 0;
      step.crossing = isAlong ? arc.start : arc.end;
      steps_.push_back(step);
      const std::int32_t last = isAlong ? arc.end : arc.start;
      if (last == kNone) continue;
      steps_.push_back({last, {}, kNone, parts_.crossings.all[at(last)].side});
      parts_.visitCorners(parts_.stretchFrom(last), [&](RegionSideIndex side) {
        steps_.push_back({kNone, {}, kNone, parts_.sideAfter(side)});
      });
    }
  }

  Point pointOf(const Step& step) const {
    if (step.crossing != kNone) return parts_.crossings.all[at(step.crossing)].point;
    if (!step.isOnEdge()) return parts_.pointOf(step.regionSide);
    const Vertex& vertex = parts_.diagram.vertices[at(parts_.diagram.originOf(step.side))];
    return {vertex.x, vertex.y};
  }
  /// Whether the start of a step is beyond the distance.
  ShiftedSign beyond(const Step& step) const {
    if (step.crossing != kNone) return signs_.beyond(sideCrossing(parts_, step.crossing));
    if (!step.isOnEdge()) return signs_.beyond(cell_, parts_.pointOf(step.regionSide));
    return signs_.beyond(parts_.diagram.originOf(step.side));
  }
  /// Whether the start of a step comes after the foot of the perpendicular on a side of the region.
  ShiftedSign pastFoot(const Step& step, Point from, Point to) const {
    if (step.crossing != kNone) return signs_.pastFoot(cell_, sideCrossing(parts_, step.crossing));
    return signs_.pastFoot(cell_, from, to, parts_.pointOf(step.regionSide));
  }

  void addLoop(bool isHole) {
    ShiftedSign first = beyond(steps_.front());
    const ShiftedSign start = first;
    cut_.beginLoop(isHole, start.sign < 0);
    bool isInside = start.sign < 0;
    for (std::size_t k = 0; k < steps_.size(); ++k) {
      const Step& step = steps_[k];
      const bool isLast = k + 1 == steps_.size();
      const Step& next = steps_[isLast ? 0 : k + 1];
      const ShiftedSign last = isLast ? start : beyond(next);
      isInside = isInside && last.sign < 0;
      if (step.isOnEdge()) {
        const Arc arc = arcOf(step);
        const Edge& edge = parts_.diagram.edges[at(arc.edge)];
        const EdgeCurve curve = parts_.curveOf(arc);
        addArcWithin(cut_, signs_, parts_.diagram, step.side, curve, arcEnd(parts_, arc.start, edge.start),
                     arcEnd(parts_, arc.end, edge.end));
        hasEdgeInside_ = hasEdgeInside_ || last.sign < 0;
      } else {
        addSide(step, next, first, last);
      }
      first = last;
    }
    cut_.endLoop();
    const RegionSideIndex side = steps_.front().regionSide;
    if (isInside && side != kNone && steps_.front().crossing == kNone)
      ringsInside_.push_back(parts_.region.ringOf(side));
  }

  void addSide(const Step& step, const Step& next, const ShiftedSign& first, const ShiftedSign& last) {
    const Point from = parts_.pointOf(step.regionSide);
    const Point to = parts_.pointOf(parts_.sideAfter(step.regionSide));
    const bool isCutFrom = first.sign > 0;
    const bool isCutTo = last.sign > 0;
    if (isCutFrom && isCutTo) {
      const bool meets = signs_.meetsRim(cell_, RimLine::ofSide(from, to)) && pastFoot(step, from, to).sign < 0 &&
                         pastFoot(next, from, to).sign > 0;
      if (!meets) return;
    }
    Point start = pointOf(step);
    Point end = pointOf(next);
    const auto rimPoint = [&](bool isAhead) {
      RimPoint point = signs_.rimPoint(cell_, RimLine::ofSide(from, to), isAhead);
      // An end exactly on the rim is the point, if it lies on this side of the foot.
      const auto isOnThisSide = [&](const ShiftedSign& past) { return past.isTie || (past.sign > 0) == isAhead; };
      const Vector along = vectorTo(from, to);
      if ((first.isTie && isOnThisSide(pastFoot(step, from, to))) || facing(vectorTo(start, point.point), along) <= 0) {
        point.point = start;
      } else if ((last.isTie && isOnThisSide(pastFoot(next, from, to))) ||
                 facing(vectorTo(point.point, end), along) <= 0) {
        point.point = end;
      }
      return point;
    };
    std::optional<RimPoint> exit;
    if (isCutTo) exit = rimPoint(true);
    if (isCutFrom) {
      const RimPoint entry = rimPoint(false);
      cut_.enter(entry);
      start = entry.point;
    }
    if (exit) end = exit->point;
    if (start != end) cut_.add({segment(start, end), kNone, kNone, 0, step.regionSide});
    if (exit) cut_.leave(*exit);
  }

  /// Whether the rim, which no loop meets, lies in the cell and the region.
  bool isRimInside() const {
    // A part of the rim lies beyond an edge in the disc: a ray from the center leaves a star-shaped cell once, and the
    // line of a straight edge divides the disc.
    if (hasEdgeInside_) return false;
    if (ringsInside_.empty()) {
      if (!signs_.hasCenter(cell_)) return false;
      const Circle c = signs_.circle(cell_);
      return parts_.placeOf(cell_) == ClipParts::Place::inside || parts_.region.contains({c.x, c.y});
    }
    // Around an outermost ring in the disc: one that has the leftmost corner, and the highest side from there.
    const auto offsets = parts_.region.ringOffsets();
    Point leftmost;
    Point highest;
    std::int32_t outermost = kNone;
    for (const std::int32_t ring : ringsInside_) {
      const std::int32_t begin = offsets[at(ring)];
      const std::int32_t end = offsets[at(ring) + 1];
      for (std::int32_t k = begin; k < end; ++k) {
        const Point p = parts_.pointOf(k);
        const Point after = parts_.pointOf(parts_.sideAfter(k));
        const Point before = parts_.pointOf(k == begin ? end - 1 : k - 1);
        const Point high = orientation(p, before, after) > 0 ? after : before;
        const bool isLeft = std::pair(p.x, p.y) < std::pair(leftmost.x, leftmost.y);
        if (outermost == kNone || isLeft || (p == leftmost && orientation(p, highest, high) > 0)) {
          leftmost = p;
          highest = high;
          outermost = ring;
        }
      }
    }
    return parts_.region.polygonOffsets()[at(parts_.region.polygonOf(outermost))] != outermost;
  }

  const ClipParts& parts_;
  CircleIndex cell_;
  DistanceSigns signs_;
  DiscLoops cut_;
  std::vector<Step> steps_;
  bool hasEdgeInside_ = false;
  std::vector<std::int32_t> ringsInside_;
};

/// Puts each hole after the loop around it.
void putHolesIntoLoops(LoopsWithin& loops, Point center) {
  const auto firstHole = std::ranges::find(loops.isHole, 1) - loops.isHole.begin();
  if (firstHole < 2 || firstHole == static_cast<std::ptrdiff_t>(loops.isHole.size())) return;
  const auto middle = std::make_move_iterator(loops.outline.begin() + firstHole);
  Outline outer(std::make_move_iterator(loops.outline.begin()), middle);
  Outline holes(middle, std::make_move_iterator(loops.outline.end()));
  std::vector<PointRing> rings(holes.size());
  for (std::size_t k = 0; k < holes.size(); ++k) {
    for (const OutlinePiece& piece : holes[k]) rings[k].push_back(piece.curve.start);
  }
  std::vector<std::vector<std::size_t>> holesOf(outer.size());
  const std::vector<std::size_t> around = loopsAround(outer, rings, center);
  for (std::size_t k = 0; k < holes.size(); ++k) holesOf[around[k]].push_back(k);
  loops = {{}, {}, loops.isSound};
  for (std::size_t k = 0; k < outer.size(); ++k) {
    loops.outline.push_back(std::move(outer[k]));
    loops.isHole.push_back(0);
    for (const std::size_t hole : holesOf[k]) {
      loops.outline.push_back(std::move(holes[hole]));
      loops.isHole.push_back(1);
    }
  }
}

}  // namespace

std::optional<ArcWithin> arcWithin(const ClipParts& parts, const Arc& arc) {
  const Edge& edge = parts.diagram.edges[at(arc.edge)];
  const DistanceSigns signs(parts.diagram, *parts.maxDistance);
  auto near = arcWithin(signs, edge, parts.curveOf(arc), arcEnd(parts, arc.start, edge.start),
                        arcEnd(parts, arc.end, edge.end));
  if (!near || near->isPoint() || !signs.hasDisc(edge.left) || !signs.hasDisc(edge.right)) return std::nullopt;
  return near;
}

LoopsWithin loopsWithin(const ClipParts& parts, CircleIndex circle, const Loops& loops) {
  if (loops.isHole.empty()) return {};
  LoopsWithin result = LoopCutter(parts, circle).run(loops);
  putHolesIntoLoops(result, parts.middleOf(circle, result.outline));
  return result;
}

AreaBounds areaBounds(const ClipParts& parts, CircleIndex circle, const Loops& loops) {
  const DistanceSigns signs(parts.diagram, *parts.maxDistance);
  const double radius = std::max(signs.radius(circle), 0.0);
  const Circle& c = parts.diagram.circles[at(circle)];
  // Along edges and sides, no point is farther from the center than both ends.
  const bool isWithin = std::ranges::all_of(loops.pieces, [&](const LoopPiece& piece) {
    return lengthOf(vectorTo({c.x, c.y}, piece.start)) < kCertainlyWithin * radius;
  });
  const double whole = parts.moments.area(at(parts.scope.cells.rowOf(circle)));
  return {isWithin ? whole : 0, std::min(whole, std::numbers::pi * radius * radius)};
}

}  // namespace circle_voronoi
