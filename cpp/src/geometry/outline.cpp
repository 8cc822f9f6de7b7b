// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "arc_measure.h"
#include "cell_limits.h"
#include "chains.h"
#include "circle_arc.h"
#include "circle_voronoi/cells.h"
#include "clip.h"
#include "ring.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

class Clipper {
 public:
  /// `disc`: the one around the circle's center that is kept, if the limits have a distance.
  Clipper(const Diagram& diagram, CircleIndex circle, const Limits& limits, const std::optional<Circle>& disc)
      : diagram_(diagram), circle_(circle), limits_(limits), ring_(limits.region, disc) {}

  Outline run() {
    if (ring_.isEmpty()) return {};
    const bool isClosed = collectChains();
    if (chains_.empty()) {
      if (contains(diagram_, circle_, ring_.middle())) return {wholeLoop(ring_)};
      return {};
    }
    if (isClosed) return {std::move(chains_.front().pieces)};
    Outline loops = joined(ring_, std::move(chains_), [&](Point p) { return depth(p); });
    if (loops.size() < 2 || !ring_.isCircle()) return loops;
    // In a disc it is in one piece: what rounding cut off where several edges end next to the circle goes.
    const auto areaOf = [](const std::vector<OutlinePiece>& loop) { return area({loop}); };
    return {*std::ranges::max_element(loops, {}, areaOf)};
  }

 private:
  /// Returns whether the sides close by themselves: the cell lies inside the region.
  bool collectChains() {
    bool linked = false;           // whether the last chain goes on with the next side
    bool firstIsAtOrigin = false;  // whether the first chain begins where its side begins
    const auto sides = diagram_.sides(circle_);
    for (const SideIndex side : sides) {
      bool goesOn = false;
      for (const auto& [piece, cutFrom, cutTo] : piecesOf(side)) {
        const bool isAtOrigin = cutFrom == kNone;
        if (!linked || !isAtOrigin) {
          if (chains_.empty()) firstIsAtOrigin = isAtOrigin && side == sides.front();
          chains_.emplace_back().entry = place(cutFrom, piece.start);
        }
        linked = false;
        goesOn = cutTo == kNone;
        chains_.back().pieces.push_back({piece, side, diagram_.neighborOf(side)});
        chains_.back().exit = place(cutTo, piece.end);
      }
      linked = goesOn;
    }
    if (!linked || !firstIsAtOrigin) return false;
    if (chains_.size() == 1) return true;
    Chain& last = chains_.back();
    last.exit = chains_.front().exit;
    std::ranges::move(chains_.front().pieces, std::back_inserter(last.pieces));
    chains_.erase(chains_.begin());
    return false;
  }

  /// The pieces of a side inside the region. Both sides of an edge are cut in the edge's own direction, so that the
  /// cells on either side meet bit for bit.
  std::vector<CurvePart> piecesOf(SideIndex side) const {
    std::vector<CurvePart> pieces = keptParts(diagram_, Diagram::edgeOf(side), limits_);
    if (side % 2 == 0) return pieces;
    std::ranges::reverse(pieces);
    for (auto& [piece, cutFrom, cutTo] : pieces) {
      piece = reversed(piece);
      std::swap(cutFrom, cutTo);
    }
    return pieces;
  }

  /// Where a chain begins or ends. Rounding may end it at a vertex next to the boundary.
  double place(std::int32_t cut, Point p) const { return cut == kNone ? ring_.placeNear(p) : ring_.placeNear(p, cut); }

  /// Returns how much nearer the circle is to a point than any neighbor, as a share of the distance of their centers.
  /// The lead over a far neighbor is rounded to more than the whole lead over a near one.
  double depth(Point p) const {
    double least = kInfinite;
    for (const SideIndex side : diagram_.sides(circle_)) {
      const CircleIndex neighbor = diagram_.neighborOf(side);
      least = std::min(least,
                       lead(diagram_, circle_, neighbor, p) / lengthOf(between(circleAt(neighbor), circleAt(circle_))));
    }
    return least;
  }

  const Circle& circleAt(CircleIndex i) const { return diagram_.circles[static_cast<std::size_t>(i)]; }

  const Diagram& diagram_;
  CircleIndex circle_;
  Limits limits_;
  Ring ring_;
  std::vector<Chain> chains_;
};

/// An area of less than this share of the square around it is but rounding.
constexpr double kRoundingOfArea = 0x1p-44;

/// The start of the first piece: moments are taken relative to it.
Point referenceOf(const Outline& outline) { return outline.front().front().curve.start; }

/// Returns about the largest distance of two of its points. The middle of a curved piece may be much farther away than
/// its ends.
double extentOf(const Outline& outline) {
  const Point reference = referenceOf(outline);
  double extent = 0;
  const auto take = [&](Point p) { extent = std::max(extent, largestOf({p.x - reference.x, p.y - reference.y})); };
  for (const auto& loop : outline) {
    for (const OutlinePiece& piece : loop) {
      const EdgeCurve& curve = piece.curve;
      take(curve.start);
      if (!curve.isStraight()) take(pointAt(curve.bisector, std::sqrt(curve.from) * std::sqrt(curve.to)));
    }
  }
  return extent;
}

Moments momentsOf(const Outline& outline, double unit) {
  const Point reference = referenceOf(outline);
  const auto toPoint = [&](Point p) { return measuredIn(unit, {p.x - reference.x, p.y - reference.y}); };
  Moments sum;
  for (const auto& loop : outline) {
    for (const OutlinePiece& piece : loop) {
      const Vector u = toPoint(piece.curve.start);
      const Vector v = toPoint(piece.curve.end);
      const double triangle = cross(u, v) / 2;
      const Moments beyond = piece.isOnCircle() ? momentsOverChord(circleArc(piece), reference, unit)
                                                : momentsOverChord(piece.curve, reference, unit);
      sum.area += triangle + beyond.area;
      sum.x += triangle * (u.x + v.x) / 3 + beyond.x;
      sum.y += triangle * (u.y + v.y) / 3 + beyond.y;
    }
  }
  return sum;
}

}  // namespace

std::vector<CurvePart> keptParts(const Diagram& diagram, EdgeIndex edge, const Limits& limits) {
  const EdgeCurve curve = edgeCurve(diagram, edge);
  if (!limits.maxDistance) return partsInside(curve, *limits.region);
  const Edge& between = diagram.edges[static_cast<std::size_t>(edge)];
  const auto near =
      partNear(curve, std::min(limits.reachFrom(diagram, between.left), limits.reachFrom(diagram, between.right)));
  if (!near) return {};
  if (limits.region == nullptr) return {*near};
  std::vector<CurvePart> parts = partsInside(near->curve, *limits.region);
  for (CurvePart& part : parts) {
    if (part.cutFrom == kNone) part.cutFrom = near->cutFrom;
    if (part.cutTo == kNone) part.cutTo = near->cutTo;
  }
  return parts;
}

Outline limitedOutline(const Diagram& diagram, CircleIndex circle, const Limits& limits) {
  if (!diagram.hasCell(circle)) return {};
  std::optional<Circle> disc;
  if (limits.maxDistance) {
    const Circle& c = diagram.circles[static_cast<std::size_t>(circle)];
    disc = {c.x, c.y, limits.reachFrom(diagram, circle)};
    if (!(disc->r > 0)) return {};
  }
  return Clipper(diagram, circle, limits, disc).run();
}

Outline outline(const Diagram& diagram, CircleIndex circle) {
  std::vector<OutlinePiece> loop;
  for (const SideIndex side : diagram.sides(circle)) {
    loop.push_back({sideCurve(diagram, side), side, diagram.neighborOf(side)});
    if (!loop.back().curve.isBounded()) return {};
  }
  return loop.empty() ? Outline{} : Outline{std::move(loop)};
}

Outline outline(const Diagram& diagram, CircleIndex circle, const ConvexPolygon& region) {
  return limitedOutline(diagram, circle, {&region});
}

Outline clippedBufferOutline(const Diagram& diagram, CircleIndex circle, const ConvexPolygon& region,
                             double maxDistance) {
  return limitedOutline(diagram, circle, {&region, maxDistance});
}

Outline bufferOutline(const Diagram& diagram, CircleIndex circle, double maxDistance) {
  return limitedOutline(diagram, circle, {nullptr, maxDistance});
}

double area(const Outline& outline) {
  if (outline.empty()) return 0;
  const double unit = unitFor(extentOf(outline));
  return momentsOf(outline, unit).area * unit * unit;
}

Point centroid(const Outline& outline) {
  if (outline.empty()) return {};
  const Point reference = referenceOf(outline);
  const double extent = extentOf(outline);
  const double unit = unitFor(extent);
  const Moments moments = momentsOf(outline, unit);
  if (extent > 0 && moments.area > kRoundingOfArea * (extent / unit) * (extent / unit)) {
    return {reference.x + unit * (moments.x / moments.area), reference.y + unit * (moments.y / moments.area)};
  }
  Vector sum;
  double count = 0;
  for (const auto& loop : outline) {
    for (const OutlinePiece& piece : loop) {
      sum.x += piece.curve.start.x - reference.x;
      sum.y += piece.curve.start.y - reference.y;
      ++count;
    }
  }
  return {reference.x + sum.x / count, reference.y + sum.y / count};
}

double perimeter(const Outline& outline) {
  double sum = 0;
  for (const auto& loop : outline) {
    for (const OutlinePiece& piece : loop) {
      sum += piece.isOnCircle() ? arcLength(circleArc(piece)) : arcLength(piece.curve);
    }
  }
  return sum;
}

}  // namespace circle_voronoi
