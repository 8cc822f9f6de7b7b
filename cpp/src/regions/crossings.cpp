// SPDX-License-Identifier: GPL-3.0-or-later
#include "crossings.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "at.h"
#include "circle_voronoi/curve.h"
#include "circle_voronoi/finder.h"
#include "refuse_clip.h"
#include "scale.h"
#include "sectors.h"
#include "shifted_signs.h"

namespace circle_voronoi {
namespace {

/// Rounding of the clearance along a walk.
constexpr double kClearance = 1 - 0x1p-30;
/// Parameters of crossings are not at infinity.
constexpr double kLeastParameter = 1e-100;
/// Rounding of the height of a place above a line, as a share of the lengths that it is made of.
constexpr double kHeightRounding = 0x1p-50;
/// Crossings are right to this share of their side.
constexpr double kCertainShare = 0x1p-44;
/// Next to the ends of their side, crossings are right to rounding.
constexpr double kNearEnd = 0x1p-30;

/// A side of the region, in the direction that both cells see.
struct Line {
  Point from;  ///< the smaller of its ends, by x and then y
  Point to;
  Vector along;
  bool isForward = true;  ///< whether the region lies on the left of this direction

  Line(Point start, Point end) : isForward(start.x < end.x || (start.x == end.x && start.y < end.y)) {
    from = isForward ? start : end;
    to = isForward ? end : start;
    along = vectorTo(from, to);
  }

  double shareOf(Point p) const { return dot(vectorTo(from, p), along) / dot(along, along); }

  Point at(double share) const {
    if (share <= 0) return from;
    if (share >= 1) return to;
    return {from.x + share * along.x, from.y + share * along.y};
  }
};

/// The crossing of a branch and a line at which the branch goes to the right of the line, or to its left.
///
/// With n the normal to the right of the line, n . (point(s) - p) > 0 becomes, multiplied by 2 s,
/// (A + B) s^2 - 2 (A + k) s + (A - B) > 0, where A = -|a| n . along, B = b n . across, k = n . (p - origin - apex
/// along). Only the ratios of A, B and k count.
struct BranchCrossing {
  double parameter = 1;
  bool isCertain = false;  ///< whether rounding moves it along the line by no more than kCertainShare of the side

  BranchCrossing(const Bisector& bisector, const Line& line, bool goesRight) {
    const double scale = powerOfTwoIn(largestOf(line.along));
    const Vector direction = measuredIn(scale, line.along);
    const Vector normal = {direction.y, -direction.x};
    const Vector toLine = vectorTo(bisector.origin, line.from);
    const double a = -std::abs(bisector.a) * dot(normal, bisector.along);
    const double b = bisector.b * dot(normal, bisector.across);
    const double k = dot(normal, toLine) - bisector.apex * dot(normal, bisector.along);
    const double half = a + k;
    const double square = k * (k + 2 * a) + b * b;
    if (!(square > 0)) return;
    const double root = std::sqrt(square);
    // The slope of the height at the root (half + root) / growth is the root's sign.
    const double own = goesRight ? root : -root;
    const double s = (half < 0) == (own < 0) ? (half + own) / (a + b) : (a - b) / (half - own);
    if (!(s > kLeastParameter && s < 1 / kLeastParameter)) return;
    parameter = s;
    // The height has an error of a rounding of `size`. It grows along the line by at least the ratio of root and size.
    const double size = std::abs(bisector.a) + bisector.b + bisector.apex + std::abs(toLine.x) + std::abs(toLine.y);
    const double steepness = root / size;
    isCertain = kHeightRounding * size < kCertainShare * scale * steepness * steepness;
  }
};

class Walk {
 public:
  Walk(const Diagram& diagram, const Region& region)
      : diagram_(diagram), region_(region), signs_(diagram), sectors_(diagram, signs_) {}

  Crossings run() {
    const Finder finder(diagram_);
    CircleIndex cell;
    for (std::size_t r = 0; r < region_.ringCount(); ++r) {
      const Point start = region_.points()[at(region_.ringOffsets()[r])];
      cell = nearestTo(start, finder.find(start, cell));
      walkRing(static_cast<std::int32_t>(r), cell);
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
        walkRing(static_cast<std::int32_t>(ring), nearestTo(region_.points()[at(begin)], near));
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

  /// `first` is the cell with the start of the ring.
  void walkRing(std::int32_t ring, CircleIndex first) {
    const std::int32_t begin = region_.ringOffsets()[at(ring)];
    const std::int32_t end = region_.ringOffsets()[at(ring) + 1];
    const auto firstCrossing = static_cast<std::int32_t>(crossings_.all.size());
    enter(first);
    clearance_ = 0;
    for (std::int32_t k = begin; k < end; ++k) walkAlong(k, startOf(k, begin, end), startOf(k + 1, begin, end));
    if (sectors_.cell() != first) refuseClip("A ring of the region does not end in the cell where it begins.");
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
        enter(nearestTo(start, near));
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

  void enter(CircleIndex cell) {
    if (sectors_.cell() != cell) sectors_.setCell(cell);
  }

  CircleIndex nearestTo(Point corner, CircleIndex from) const { return cellWith(diagram_, signs_, corner, from); }

  /// The crossings of edges of chosen cells. Between one where the boundary comes into such a cell and the next one
  /// there is no other.
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

  void walkAlong(RegionSideIndex index, Point start, Point end) {
    const double length = lengthOf(vectorTo(start, end));
    if (length < clearance_) {
      clearance_ = (clearance_ - length) * kClearance;
      return;
    }
    if (staysInCell(start, end, length)) return;
    const Line line(start, end);
    std::optional<Sectors::Sector> sector;
    // A line crosses an edge twice at most.
    for (std::size_t steps = 0; steps <= 2 * diagram_.edges.size(); ++steps) {
      const bool endsInCell = isInCell(end);
      const bool isEntered = sector.has_value();
      std::optional<SideIndex> exit;
      if (diagram_.metric == Metric::circles) {
        if (sectors_.sides().empty()) return;
        if (!sector) sector = sectors_.find(start);
        exit = sectors_.exitFrom(*sector, isEntered, {start, end}, endsInCell);
      } else if (!endsInCell) {
        exit = straightExit({start, end});
      }
      if (!exit) return;
      addCrossing(index, line, *exit);
      enter(diagram_.neighborOf(*exit));
      sector.emplace();
      if (diagram_.metric == Metric::circles) *sector = sectors_.entered(Diagram::twin(*exit), {start, end});
    }
    refuseClip("A side of the region crosses edges again and again.");
  }

  /// Returns whether a side certainly stays in the cell of the walk. Sets `clearance_` to a lower bound of the distance
  /// of its end from the border of the cell.
  bool staysInCell(Point start, Point end, double length) {
    clearance_ = kInfinite;
    const Circle& c = diagram_.circles[at(sectors_.cell())];
    bool stays = true;
    for (const SideIndex side : sectors_.sides()) {
      const CircleIndex neighbor = diagram_.neighborOf(side);
      const double atEnd = signs_.compare(sectors_.cell(), neighbor, end).least;
      if (!(atEnd > 0)) return false;
      clearance_ = std::min(clearance_, atEnd);
      if (length < atEnd) continue;
      const double atStart = signs_.compare(sectors_.cell(), neighbor, start).least;
      // The region of points nearer to a circle than to a larger one is convex.
      const bool isConvex = diagram_.metric != Metric::circles || c.r <= diagram_.circles[at(neighbor)].r;
      stays = stays && (isConvex ? atStart > 0 : atStart + atEnd > length);
    }
    return stays;
  }

  /// Returns whether the cell of the walk has a corner. Sets `clearance_` to a lower bound of its distance from the
  /// border of the cell.
  bool isInCell(Point corner) {
    clearance_ = kInfinite;
    for (const SideIndex side : sectors_.sides()) {
      const auto comparison = signs_.compare(sectors_.cell(), diagram_.neighborOf(side), corner);
      if (comparison.sign < 0) return false;
      clearance_ = std::min(clearance_, comparison.least);
    }
    return true;
  }

  /// Returns the side across which a line leaves a convex cell.
  SideIndex straightExit(const ShiftedSigns::Line& line) const {
    for (const SideIndex side : sectors_.sides()) {
      if (signs_.sideOfEnd(side, false, line) < 0 && signs_.sideOfEnd(side, true, line) > 0) return side;
    }
    refuseClip("A side of the region does not leave a cell in which it does not end.");
  }

  /// Adds the crossing where a line leaves the cell of a side across it: the side goes from the right of the line to
  /// its left.
  void addCrossing(RegionSideIndex index, const Line& line, SideIndex side) {
    const EdgeIndex edge = Diagram::edgeOf(side);
    const Edge& ends = diagram_.edges[at(edge)];
    // All edges of two circles have one bisector, and the one of smaller index on its left.
    const auto [left, right] = std::minmax({std::int32_t{ends.left}, std::int32_t{ends.right}});
    const Bisector bisector =
        circle_voronoi::bisector(diagram_.circles[at(left)], diagram_.circles[at(right)], diagram_.metric);
    const bool isAlong = left == diagram_.circleOf(side);
    const BranchCrossing found(bisector, line, isAlong != line.isForward);
    double parameter = found.parameter;
    double share = line.shareOf(pointAt(bisector, parameter));
    Point point = line.at(share);
    if (!found.isCertain || !(share > kNearEnd && share < 1 - kNearEnd)) {
      const CircleIndex own = diagram_.circleOf(side);
      const CircleIndex other = diagram_.neighborOf(side);
      const auto& [out, in] = line.isForward ? std::pair(own, other) : std::pair(other, own);
      share = std::clamp(signs_.shareOfCrossing(out, in, {line.from, line.to}), 0.0, 1.0);
      point = line.at(share);
      if (share > 0.5) {
        // Next to the other end, which may be much nearer to the circles, as seen from there.
        const double rest = std::clamp(signs_.shareOfCrossing(in, out, {line.to, line.from}), 0.0, 1.0);
        share = 1 - rest;
        if (rest < 1) point = {line.to.x - rest * line.along.x, line.to.y - rest * line.along.y};
      }
      parameter = parameterAt(bisector, point);
    }
    if (left != ends.left) parameter = 1 / parameter;
    const EdgeCurve curve = edgeCurve(diagram_, edge);
    parameter = std::clamp(parameter, curve.from, curve.to);
    crossings_.all.push_back({edge, index, point, parameter, share, side % 2 == 0});
  }

  const Diagram& diagram_;
  const Region& region_;
  ShiftedSigns signs_;
  Sectors sectors_;  ///< of the current cell
  double clearance_ = 0;
  Crossings crossings_;
};

}  // namespace

Crossings crossingsOf(const Diagram& diagram, const Region& region) { return Walk(diagram, region).run(); }

Crossings crossingsOf(const Diagram& diagram, const Region& region, std::span<const CircleIndex> circles) {
  std::vector<std::uint8_t> isChosen(diagram.circles.size(), 0);
  Box box = {kInfinite, kInfinite, -kInfinite, -kInfinite};
  const auto include = [&](Point p, double margin) {
    box = {std::min(box.minX, p.x - margin), std::min(box.minY, p.y - margin), std::max(box.maxX, p.x + margin),
           std::max(box.maxY, p.y + margin)};
  };
  const ShiftedSigns signs(diagram);
  CircleIndex near;
  const Box bounds = region.bounds();
  for (const CircleIndex circle : circles) {
    if (!diagram.hasCell(circle)) continue;
    isChosen[at(circle)] = 1;
    near = circle;
    bool isBounded = !diagram.sides(circle).empty();
    for (const SideIndex side : diagram.sides(circle)) {
      const VertexIndex origin = diagram.originOf(side);
      const VertexIndex target = diagram.targetOf(side);
      isBounded = origin != kNone && target != kNone;
      if (!isBounded) break;
      // Twice the error of vertices, which moves the points between them.
      const double margin = 2 * std::max(signs.errorOf(origin), signs.errorOf(target));
      const EdgeCurve curve = edgeCurve(diagram, Diagram::edgeOf(side));
      include(curve.start, margin);
      include(curve.end, margin);
      if (!curve.isStraight()) include(rationalBezier(curve).control, margin);
    }
    if (isBounded) continue;
    include({bounds.minX, bounds.minY}, 0);
    include({bounds.maxX, bounds.maxY}, 0);
  }
  if (near == kNone) return {};
  return Walk(diagram, region).run(box, isChosen, near);
}

CircleIndex cellWith(const Diagram& diagram, const ShiftedSigns& signs, Point corner, CircleIndex from) {
  for (std::size_t steps = 0; steps <= diagram.circles.size(); ++steps) {
    CircleIndex best = from;
    for (const SideIndex side : diagram.sides(from)) {
      const CircleIndex neighbor = diagram.neighborOf(side);
      if (neighbor != best && signs.compare(best, neighbor, corner).sign < 0) best = neighbor;
    }
    if (best == from) return from;
    from = best;
  }
  refuseClip("No cell of the diagram has a corner of the region.");
}

}  // namespace circle_voronoi
