// SPDX-License-Identifier: GPL-3.0-or-later
#include "crossings.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "at.h"
#include "circle_voronoi/curve.h"
#include "circle_voronoi/finder.h"
#include "edge_curve.h"
#include "refuse_clip.h"
#include "scale.h"
#include "sectors.h"
#include "shifted_signs.h"
#include "side_after.h"
#include "sort_unique.h"

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
/// Rounding of directions, as a share of their length.
constexpr double kUncertainDirection = 0x1p-30;

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

  /// Returns the share of the way at a place relative to the start.
  double shareOf(Point p) const { return dot({p.x, p.y}, along) / dot(along, along); }

  Point at(double share) const {
    if (share <= 0) return from;
    if (share >= 1) return to;
    return {from.x + share * along.x, from.y + share * along.y};
  }
};

/// Returns a bisector in coordinates relative to a point. Far from the origin, these round less.
Bisector relativeTo(Point p, Bisector bisector) {
  const Vector origin = vectorTo(p, bisector.origin);
  bisector.origin = {origin.x, origin.y};
  return bisector;
}

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

  /// Walks along all rings.
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

  /// Finds where the boundary comes into each of some cells, and follows it from there until it leaves the cell.
  Crossings run(const Chosen& cells) {
    for (std::size_t row = 0; row < cells.size(); ++row) {
      const CircleIndex cell = cells[row];
      if (diagram_.hasCell(cell)) walkIn(cell);
    }
    return joined();
  }

 private:
  /// `first` is the cell with the start of the ring.
  void walkRing(std::int32_t ring, CircleIndex first) {
    const std::int32_t begin = region_.ringOffsets()[at(ring)];
    const std::int32_t end = region_.ringOffsets()[at(ring) + 1];
    const std::size_t firstCrossing = crossings_.all.size();
    enter(first);
    clearance_ = 0;
    for (std::int32_t k = begin; k < end; ++k) {
      walkAlong(k, region_.points()[at(k)], region_.points()[at(k + 1 == end ? begin : k + 1)]);
    }
    if (sectors_.cell() != first) refuseClip("A ring of the region does not end in the cell where it begins.");
    const std::size_t count = crossings_.all.size();
    for (std::size_t c = firstCrossing; c < count; ++c) {
      const bool isLast = c + 1 == count;
      crossings_.next.push_back(static_cast<std::int32_t>(isLast ? firstCrossing : c + 1));
      crossings_.isOnSideOfNext.push_back(!isLast && crossings_.all[c].side == crossings_.all[c + 1].side ? 1 : 0);
    }
    if (firstCrossing == count) crossings_.rings.push_back({first, ring});
  }

  /// Adds the crossings of the border of a cell, and the rings inside it.
  void walkIn(CircleIndex cell) {
    enter(cell);
    Box box = {kInfinite, kInfinite, -kInfinite, -kInfinite};
    bool isBounded = !sectors_.sides().empty();
    std::vector<std::int32_t> crossedRings;
    for (const SideIndex side : sectors_.sides()) {
      isBounded = isBounded && diagram_.targetOf(side) != kNone;
      const Box its = boxAround(side);
      box = {std::min(box.minX, its.minX), std::min(box.minY, its.minY), std::max(box.maxX, its.maxX),
             std::max(box.maxY, its.maxY)};
      for (const RegionSideIndex index : region_.sidesIn(its)) {
        const RegionRingIndex ring = region_.ringOf(index);
        const auto [start, end] = endsOf(index, ring);
        if (!sectors_.isEnteredAcross(side, {start, end})) continue;
        crossedRings.push_back(ring);
        follow(side, index, ring);
      }
    }
    addRingsIn(isBounded ? box : region_.bounds(), std::move(crossedRings));
  }

  /// Follows the boundary from where a side of the region comes into the cell of the walk, until it leaves the cell.
  void follow(SideIndex across, RegionSideIndex index, RegionRingIndex ring) {
    const auto [start, end] = endsOf(index, ring);
    addCrossing(index, Line(start, end), Diagram::twin(across));
    auto exit = exitAlong({start, end}, across);
    crossings_.isOnSideOfNext.push_back(exit ? 1 : 0);
    const std::int32_t size = region_.ringOffsets()[at(ring) + 1] - region_.ringOffsets()[at(ring)];
    for (std::int32_t steps = 0; !exit; ++steps) {
      if (steps > size) refuseClip("A ring of the region does not leave a cell.");
      index = sideAfter(region_, index, ring);
      const auto [from, to] = endsOf(index, ring);
      if (!isShort(from, to)) exit = exitAlong({from, to});
    }
    const auto [from, to] = endsOf(index, ring);
    addCrossing(index, Line(from, to), *exit);
    crossings_.isOnSideOfNext.push_back(0);
  }

  /// Adds the rings that lie in the cell of the walk: in a box, and not crossed.
  void addRingsIn(const Box& box, std::vector<std::int32_t> crossedRings) {
    sortUnique(crossedRings);
    const auto sides = region_.sidesIn(box);
    const auto offsets = region_.ringOffsets();
    for (std::size_t k = 0; k < sides.size();) {
      const std::int32_t ring = region_.ringOf(sides[k]);
      const std::size_t first = k;
      while (k < sides.size() && sides[k] < offsets[at(ring) + 1]) ++k;
      const bool isWhole = k - first == at(offsets[at(ring) + 1] - offsets[at(ring)]);
      if (!isWhole || std::ranges::binary_search(crossedRings, ring)) continue;
      if (isInCell(region_.points()[at(offsets[at(ring)])])) crossings_.rings.push_back({sectors_.cell(), ring});
    }
  }

  /// Joins the crossings that were found from both cells of an edge. They were added in pairs: where the boundary comes
  /// into a cell, and where it leaves the cell.
  Crossings joined() {
    const auto& all = crossings_.all;
    // A line crosses an edge once at most in each direction.
    const auto key = [&](std::int32_t c) {
      const Crossing& its = all[at(c)];
      return std::tuple(std::int32_t{its.side}, std::int32_t{its.edge}, its.isEntry);
    };
    std::vector<std::int32_t> order(all.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, {}, key);
    std::vector<std::int32_t> places(all.size());
    Crossings result;
    for (std::size_t k = 0; k < order.size(); ++k) {
      if (k == 0 || key(order[k]) != key(order[k - 1])) result.all.push_back(all[at(order[k])]);
      places[at(order[k])] = static_cast<std::int32_t>(result.all.size()) - 1;
    }
    result.next.assign(result.all.size(), kNone);
    result.isOnSideOfNext.assign(result.all.size(), 0);
    for (std::size_t c = 0; c < all.size(); c += 2) {
      result.next[at(places[c])] = places[c + 1];
      result.isOnSideOfNext[at(places[c])] = crossings_.isOnSideOfNext[c];
    }
    result.rings = std::move(crossings_.rings);
    return result;
  }

  std::pair<Point, Point> endsOf(RegionSideIndex side, RegionRingIndex ring) const {
    return {region_.points()[at(side)], region_.points()[at(sideAfter(region_, side, ring))]};
  }

  /// A box around a side of a cell. An arc lies in the triangle of its ends and its tangents there. Towards infinity it
  /// goes between the directions of its tangent and of its asymptote.
  Box boxAround(SideIndex side) const {
    const EdgeCurve curve = edgeCurve(diagram_, Diagram::edgeOf(side));
    Box box = {kInfinite, kInfinite, -kInfinite, -kInfinite};
    const auto include = [&](Point p, double margin) {
      box = {std::min(box.minX, p.x - margin), std::min(box.minY, p.y - margin), std::max(box.maxX, p.x + margin),
             std::max(box.maxY, p.y + margin)};
    };
    double margin = 0;
    for (const VertexIndex vertex : {diagram_.originOf(side), diagram_.targetOf(side)}) {
      // Twice the error of vertices, which moves the points between them.
      if (vertex != kNone) margin = std::max(margin, 2 * signs_.errorOf(vertex));
    }
    if (!curve.startsAtInfinity()) include(curve.start, margin);
    if (!curve.endsAtInfinity()) include(curve.end, margin);
    if (curve.isBounded()) {
      if (curve.isStraight()) return box;
      const Point control = rationalBezier(curve).control;
      include(control, margin + kHeightRounding * (std::abs(control.x) + std::abs(control.y)));
      return box;
    }
    const Bisector& bisector = curve.bisector;
    const double a = std::abs(bisector.a);
    const auto extend = [&](double along, double across) {
      const Vector direction = {along * bisector.along.x + across * bisector.across.x,
                                along * bisector.along.y + across * bisector.across.y};
      const double least = kUncertainDirection * (std::abs(along) + std::abs(across));
      if (!(direction.x > least)) box.minX = -kInfinite;
      if (!(direction.x < -least)) box.maxX = kInfinite;
      if (!(direction.y > least)) box.minY = -kInfinite;
      if (!(direction.y < -least)) box.maxY = kInfinite;
    };
    for (const double sign : {1.0, -1.0}) {
      const bool isForward = sign > 0;
      if (!(isForward ? curve.endsAtInfinity() : curve.startsAtInfinity())) continue;
      extend(-a, sign * bisector.b);
      // At a finite end, the derivative of point(s) times 2 s.
      const double s = isForward ? curve.from : 1 / curve.to;
      if (s > 0 && !curve.isStraight()) extend(-a * (s - 1 / s), sign * bisector.b * (s + 1 / s));
    }
    if (curve.startsAtInfinity() && curve.endsAtInfinity()) box = {-kInfinite, -kInfinite, kInfinite, kInfinite};
    return box;
  }

  void enter(CircleIndex cell) {
    if (sectors_.cell() != cell) sectors_.setCell(cell);
  }

  /// The circle whose cell has a corner, by steps to nearer neighbors.
  CircleIndex nearestTo(Point corner, CircleIndex from) {
    for (std::size_t steps = 0; steps <= diagram_.circles.size(); ++steps) {
      enter(from);
      const CircleIndex nearer = nearerNeighbor(corner);
      if (nearer == kNone) return from;
      from = nearer;
    }
    refuseClip("No cell of the diagram has a corner of the region.");
  }

  /// A neighbor of the cell of the walk whose circle is nearer to a corner, or kNone.
  CircleIndex nearerNeighbor(Point corner) const {
    CircleIndex best = sectors_.cell();
    if (isStarWithManySides()) {
      const Sectors::Sector sector = sectors_.find(corner);
      return sectors_.compareIn(sector, corner).sign > 0 ? CircleIndex()
                                                         : diagram_.neighborOf(sectors_.sides()[sector.side]);
    }
    for (const SideIndex side : sectors_.sides()) {
      const CircleIndex neighbor = diagram_.neighborOf(side);
      if (neighbor != best && signs_.compare(best, neighbor, corner).sign < 0) best = neighbor;
    }
    return best == sectors_.cell() ? CircleIndex() : best;
  }

  /// Whether the cell has so many sides that sectors are found faster.
  bool isStarWithManySides() const { return sectors_.hasManySides() && diagram_.metric == Metric::circles; }

  void walkAlong(RegionSideIndex index, Point start, Point end) {
    if (isShort(start, end)) return;
    const Line line(start, end);
    auto exit = exitAlong({start, end});
    // A line crosses an edge twice at most.
    for (std::size_t steps = 0; steps <= 2 * diagram_.edges.size(); ++steps) {
      if (!exit) return;
      addCrossing(index, line, *exit);
      enter(diagram_.neighborOf(*exit));
      exit = exitAlong({start, end}, Diagram::twin(*exit));
    }
    refuseClip("A side of the region crosses edges again and again.");
  }

  /// Returns whether a side that begins in the cell of the walk certainly stays there. Updates `clearance_`.
  bool isShort(Point start, Point end) {
    const double length = lengthOf(vectorTo(start, end));
    if (length < clearance_) {
      clearance_ = (clearance_ - length) * kClearance;
      return true;
    }
    return staysInCell(start, end, length);
  }

  /// Returns the side across which a line leaves the cell of the walk before its end: from its start, or from where it
  /// enters the cell across a side. Updates `clearance_`.
  std::optional<SideIndex> exitAlong(const ShiftedSigns::Line& line, SideIndex enteredAcross = {}) {
    const bool endsInCell = isInCell(line.to);
    if (diagram_.metric != Metric::circles) {
      return endsInCell ? std::nullopt : std::optional(straightExit(line));
    }
    if (sectors_.sides().empty()) return std::nullopt;
    const bool isEntered = enteredAcross != kNone;
    const Sectors::Sector sector = isEntered ? sectors_.entered(enteredAcross, line) : sectors_.find(line.from);
    return sectors_.exitFrom(sector, isEntered, line, endsInCell);
  }

  /// Returns whether a side certainly stays in the cell of the walk. Sets `clearance_` to a lower bound of the distance
  /// of its end from the border of the cell.
  bool staysInCell(Point start, Point end, double length) {
    clearance_ = kInfinite;
    const Circle& c = diagram_.circles[at(sectors_.cell())];
    if (isStarWithManySides()) {
      clearance_ = clearanceInDisc(end);
      return clearance_ > 0 && clearanceInDisc(start) > 0;
    }
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
    if (isStarWithManySides()) {
      clearance_ = clearanceInDisc(corner);
      return clearance_ > 0 || sectors_.compareIn(sectors_.find(corner), corner).sign > 0;
    }
    for (const SideIndex side : sectors_.sides()) {
      const auto comparison = signs_.compare(sectors_.cell(), diagram_.neighborOf(side), corner);
      if (comparison.sign < 0) return false;
      clearance_ = std::min(clearance_, comparison.least);
    }
    return true;
  }

  /// Returns a lower bound of the distance of a corner from the border of a cell with many sides.
  double clearanceInDisc(Point corner) const {
    const Circle& c = diagram_.circles[at(sectors_.cell())];
    return (sectors_.innerRadius() - lengthOf(vectorTo({c.x, c.y}, corner))) * kClearance;
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
    // All edges of two circles have one bisector, whatever their directions.
    const bool isInOrder = isOrdered(diagram_, edge);
    const CircleIndex left = isInOrder ? ends.left : ends.right;
    const CircleIndex right = isInOrder ? ends.right : ends.left;
    const Bisector bisector =
        circle_voronoi::bisector(diagram_.circles[at(left)], diagram_.circles[at(right)], diagram_.metric);
    const bool isAlong = left == diagram_.circleOf(side);
    const BranchCrossing found(bisector, line, isAlong != line.isForward);
    double parameter = found.parameter;
    const Bisector fromStart = relativeTo(line.from, bisector);
    double share = line.shareOf(pointAt(fromStart, parameter));
    Point point = line.at(share);
    if (!found.isCertain || !(share > kNearEnd && share < 1 - kNearEnd)) {
      const CircleIndex own = diagram_.circleOf(side);
      const CircleIndex other = diagram_.neighborOf(side);
      const auto& [out, in] = line.isForward ? std::pair(own, other) : std::pair(other, own);
      share = std::clamp(signs_.shareOfCrossing(out, in, {line.from, line.to}), 0.0, 1.0);
      point = line.at(share);
      parameter = parameterAt(fromStart, {share * line.along.x, share * line.along.y});
      if (share > 0.5) {
        // Next to the other end, which may be much nearer to the circles, as seen from there.
        const double rest = std::clamp(signs_.shareOfCrossing(in, out, {line.to, line.from}), 0.0, 1.0);
        share = 1 - rest;
        if (rest < 1) point = {line.to.x - rest * line.along.x, line.to.y - rest * line.along.y};
        parameter = parameterAt(relativeTo(line.to, bisector), {-rest * line.along.x, -rest * line.along.y});
      }
    }
    const EdgeCurve curve = orderedCurve(diagram_, edge);
    parameter = std::clamp(parameter, curve.from, curve.to);
    crossings_.all.push_back(
        {edge, index, point, isInOrder ? parameter : 1 / parameter, parameter, share, side % 2 == 0});
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

Crossings crossingsOf(const Diagram& diagram, const Region& region, const Chosen& cells) {
  return Walk(diagram, region).run(cells);
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
