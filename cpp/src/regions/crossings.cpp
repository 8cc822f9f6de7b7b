// SPDX-License-Identifier: GPL-3.0-or-later
#include "crossings.h"

#include <algorithm>
#include <array>
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
    const double reach = (std::abs(bisector.a) + bisector.b) * (s + 1 / s) / 2;  // the branch's own share of the place
    const double size = reach + bisector.apex + std::abs(toLine.x) + std::abs(toLine.y);
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
      sectors_.setCellWith(start, finder.find(start, cell));
      cell = sectors_.cell();
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
    sectors_.setCell(first);
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
    sectors_.setCell(cell);
    std::vector<std::int32_t> crossedRings;
    for (const SideIndex side : sectors_.sides()) {
      const Hull hull = hullOf(side);
      for (const RegionSideIndex index : region_.sidesNear(hull.corners, hull.margin)) {
        const RegionRingIndex ring = region_.ringOf(index);
        const auto [start, end] = endsOf(index, ring);
        if (!sectors_.isEnteredAcross(side, {start, end})) continue;
        crossedRings.push_back(ring);
        follow(side, index, ring);
      }
    }
    addRings(std::move(crossedRings));
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

  /// Adds the rings that lie in the cell of the walk: those that begin there and are not crossed.
  void addRings(std::vector<std::int32_t> crossedRings) {
    sortUnique(crossedRings);
    const auto cornerOf = [&](std::int32_t ring) { return region_.points()[at(region_.ringOffsets()[at(ring)])]; };
    const auto isOutside = [&](const Box& box, std::int32_t first) { return isBeyond(box, cornerOf(first)); };
    for (const std::int32_t ring : region_.ringsNotIn(isOutside)) {
      if (std::ranges::binary_search(crossedRings, ring) || !isInCell(cornerOf(ring))) continue;
      crossings_.rings.push_back({sectors_.cell(), ring});
    }
  }

  /// Returns whether a neighbor of the cell of the walk is certainly nearer to all of a box around a corner.
  bool isBeyond(const Box& box, Point corner) const {
    const double reach = lengthOf(
        {std::max(corner.x - box.minX, box.maxX - corner.x), std::max(corner.y - box.minY, box.maxY - corner.y)});
    const auto isNearer = [&](SideIndex side) {
      const CircleIndex neighbor = diagram_.neighborOf(side);
      const auto comparison = [&](Point p) { return signs_.compare(neighbor, sectors_.cell(), p); };
      if (comparison(corner).sign < 0) return false;
      if (!isConvexBetween(neighbor, sectors_.cell())) return comparison(corner).least * kClearance > reach;
      const std::array<Point, 4> corners = {Point{box.minX, box.minY}, Point{box.maxX, box.minY},
                                            Point{box.maxX, box.maxY}, Point{box.minX, box.maxY}};
      return std::ranges::all_of(corners, [&](Point p) { return comparison(p).sign > 0; });
    };
    if (!sectors_.isStarWithManySides()) return std::ranges::any_of(sectors_.sides(), isNearer);
    const Sectors::Sector sector = sectors_.find(corner);
    return sectors_.compareIn(sector, corner).sign < 0 && isNearer(sectors_.sides()[sector.side]);
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

  /// A convex polygon, around which a side of a cell lies in a margin as far as it is in the box of the region.
  struct Hull {
    std::vector<Point> corners;
    double margin = 0;
  };

  /// An arc lies in the triangle of its ends and its tangents there. Towards infinity it goes between the directions of
  /// its tangent and of its asymptote.
  Hull hullOf(SideIndex side) const {
    const EdgeCurve curve = edgeCurve(diagram_, Diagram::edgeOf(side));
    const Edge& edge = diagram_.edges[at(Diagram::edgeOf(side))];
    const Box box = region_.bounds();
    const double most = kUncertainDirection * ((box.maxX - box.minX) + (box.maxY - box.minY));
    Hull hull;
    // A far vertex that is less exact counts as one at infinity.
    const auto isOpen = [&](VertexIndex vertex) {
      if (vertex == kNone) return true;
      // Twice the error of vertices, which moves the points between them.
      const double margin = 2 * signs_.errorOf(vertex);
      if (margin > most) return true;
      hull.margin = std::max(hull.margin, margin);
      return false;
    };
    const bool opensAtStart = isOpen(edge.start);
    const bool opensAtEnd = isOpen(edge.end);
    if (!opensAtStart && !opensAtEnd) {
      hull.corners = {curve.start, curve.end};
      if (curve.isStraight()) return hull;
      const Point control = rationalBezier(curve).control;
      hull.corners.push_back(control);
      hull.margin += kHeightRounding * (std::abs(control.x) + std::abs(control.y));
      return hull;
    }
    const Bisector& bisector = curve.bisector;
    const bool isWhole = opensAtStart && opensAtEnd;
    const Point start = isWhole ? pointAt(bisector, 1) : opensAtStart ? curve.end : curve.start;
    const double farthest =
        lengthOf({std::max(start.x - box.minX, box.maxX - start.x), std::max(start.y - box.minY, box.maxY - start.y)});
    // The tangent, that at the apex if it comes later, and the asymptote are at most a right angle apart, so the lines
    // between the places at this distance do not meet the box.
    const double distance = 2 * farthest;
    hull.margin += kUncertainDirection * distance;
    const double a = std::abs(bisector.a);
    if (!isWhole) hull.corners.push_back(start);
    for (const double sign : {1.0, -1.0}) {
      if (!(sign > 0 ? opensAtEnd : opensAtStart)) continue;
      std::vector<Point> corners;
      const auto addToward = [&](double along, double across) {
        const Vector direction = {along * bisector.along.x + across * bisector.across.x,
                                  along * bisector.along.y + across * bisector.across.y};
        const double share = distance / lengthOf(direction);
        corners.push_back({start.x + share * direction.x, start.y + share * direction.y});
      };
      // The derivative of point(s) times 2 s.
      const auto addTangentAt = [&](double s) { addToward(-a * (s - 1 / s), sign * bisector.b * (s + 1 / s)); };
      const double first = isWhole ? 1 : sign > 0 ? curve.from : 1 / curve.to;
      if (!curve.isStraight()) addTangentAt(first);
      if (!curve.isStraight() && first < 1) addTangentAt(1);
      addToward(-a, sign * bisector.b);
      if (sign < 0) std::ranges::reverse(corners);
      hull.corners.insert(hull.corners.end(), corners.begin(), corners.end());
    }
    return hull;
  }

  /// Whether the points nearer to a circle than to another one make up a convex set. The other circle is as large or
  /// larger, then.
  bool isConvexBetween(CircleIndex circle, CircleIndex other) const {
    return diagram_.metric != Metric::circles || diagram_.circles[at(circle)].r <= diagram_.circles[at(other)].r;
  }

  void walkAlong(RegionSideIndex index, Point start, Point end) {
    if (isShort(start, end)) return;
    const Line line(start, end);
    auto exit = exitAlong({start, end});
    // A line crosses an edge twice at most.
    for (std::size_t steps = 0; steps <= 2 * diagram_.edges.size(); ++steps) {
      if (!exit) return;
      addCrossing(index, line, *exit);
      sectors_.setCell(diagram_.neighborOf(*exit));
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
    if (sectors_.isStarWithManySides()) {
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
      const bool isConvex = isConvexBetween(sectors_.cell(), neighbor);
      stays = stays && (isConvex ? atStart > 0 : atStart + atEnd > length);
    }
    return stays;
  }

  /// Returns whether the cell of the walk has a corner. Sets `clearance_` to a lower bound of its distance from the
  /// border of the cell.
  bool isInCell(Point corner) {
    clearance_ = kInfinite;
    if (sectors_.isStarWithManySides()) {
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
    const Bisector bisector = circle_voronoi::bisector(diagram_.circles[at(left)], diagram_.circles[at(right)],
                                                       diagram_.metric, diagram_.weights);
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

}  // namespace circle_voronoi
