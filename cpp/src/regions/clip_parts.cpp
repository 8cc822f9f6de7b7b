// SPDX-License-Identifier: GPL-3.0-or-later
#include "clip_parts.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "at.h"
#include "cell_limits.h"
#include "edge_curve.h"
#include "judge_clip.h"
#include "judge_within.h"
#include "nesting.h"
#include "ordered_sides.h"
#include "part_within.h"
#include "refuse_clip.h"
#include "scale.h"
#include "with_key.h"

namespace circle_voronoi {

namespace {

/// Rounding of the area under one piece, as a share of the rounding that an outline may have.
constexpr double kRoundingOfPiece = 0x1p-10;

Crossings crossingsFor(const Diagram& diagram, const Region& region, const ClipScope& scope) {
  if (diagram.hull.empty()) return {};
  return scope.isAll() ? crossingsOf(diagram, region) : crossingsOf(diagram, region, scope.cells);
}

}  // namespace

ClipParts::ClipParts(const Diagram& its, const Region& itsRegion, std::optional<double> itsMaxDistance,
                     std::optional<std::span<const CircleIndex>> circles, const VisitArc& visit)
    : diagram(its),
      region(itsRegion),
      maxDistance(itsMaxDistance),
      bounds(itsRegion.bounds()),
      scope(its, circles),
      crossings(crossingsFor(its, itsRegion, scope)),
      arcs(its, itsRegion, scope, crossings) {
  const ClipRecord record = {diagram, region, scope, crossings, arcs.levels(), arcs.all()};
  if (const char* fault = faultOf(record)) refuseClip(fault);
  places_.assign(scope.cells.size(), Place::outside);
  for (std::size_t row = 0; row < places_.size(); ++row) {
    const SideIndex side = diagram.links.firstSide[at(scope.cells[row])];
    if (side != kNone && arcs.isInside(diagram.originOf(side))) places_[row] = Place::inside;
  }
  into_.reserve(crossings.all.size());
  for (std::size_t c = 0; c < crossings.all.size(); ++c) {
    const CircleIndex cell = cellAfter(crossings.all[c]);
    if (scope.cells.has(cell)) into_.push_back({cell, static_cast<std::int32_t>(c)});
  }
  // A side of the region comes into a cell once at most from each neighbor.
  std::ranges::sort(into_, {}, [this](const InCell& one) {
    const Crossing& crossing = crossings.all[at(one.index)];
    const Point start = pointOf(crossing.side);
    const Point end = pointOf(sideAfter(crossing.side));
    const bool isForward = start.x < end.x || (start.x == end.x && start.y < end.y);
    const Edge& edge = diagram.edges[at(crossing.edge)];
    return std::tuple(std::int32_t{one.cell}, std::int32_t{crossing.side}, isForward ? crossing.share : -crossing.share,
                      orderOf(diagram, crossing.isEntry ? edge.left : edge.right));
  });
  placesInto_.assign(crossings.all.size(), kNone);
  for (std::size_t k = 0; k < into_.size(); ++k) placesInto_[at(into_[k].index)] = static_cast<std::int32_t>(k);
  for (const auto& [cell, ring] : crossings.rings) rings_.push_back({cell, ring});
  std::ranges::sort(rings_, {}, [](const InCell& one) { return std::pair(std::int32_t{one.cell}, one.index); });
  for (const auto* list : {&into_, &rings_}) {
    for (const InCell& one : *list) places_[at(scope.cells.rowOf(one.cell))] = Place::cut;
  }
  moments = momentsOf(*this, visit);
  if (const char* fault = faultOf(record, moments)) refuseClip(fault);
  if (maxDistance) judgePartsWithin();
}

/// Judges the cells that the boundary of the region cuts. Around other rims, exits and entries alternate as the sides
/// of the cell follow each other.
void ClipParts::judgePartsWithin() const {
  const DistanceSigns signs(diagram, *maxDistance);
  Loops loops;
  for (std::size_t row = 0; row < scope.cells.size(); ++row) {
    const CircleIndex circle = scope.cells[row];
    if (placeOf(circle) != Place::cut) continue;
    loopsOf(circle, loops);
    const double size = std::max({signs.radius(circle), bounds.maxX - bounds.minX, bounds.maxY - bounds.minY});
    const Circle& c = diagram.circles[at(circle)];
    const double farthest = std::max({std::abs(c.x), std::abs(c.y), size});
    const double pieces = std::max(1.0, kRoundingOfPiece * static_cast<double>(loops.pieces.size()));
    const double rounding = kRounding * pieces * size * farthest;
    const AreaBounds areas = areaBounds(*this, circle, loops);
    if (const char* fault = faultOf(loopsWithin(*this, circle, loops), areas, rounding)) {
      refuseClip(fault);
    }
  }
}

std::span<const ClipParts::InCell> ClipParts::within(const std::vector<InCell>& all, CircleIndex cell) {
  return withKey(all, std::int32_t{cell}, [](const InCell& one) { return std::int32_t{one.cell}; });
}

EdgeCurve ClipParts::orderedCurveOf(const Arc& arc) const {
  EdgeCurve curve = orderedCurve(diagram, arc.edge);
  const auto& [first, last] =
      isOrdered(diagram, arc.edge) ? std::pair(arc.start, arc.end) : std::pair(arc.end, arc.start);
  if (first != kNone) {
    curve.from = crossings.all[at(first)].orderedParameter;
    curve.start = crossings.all[at(first)].point;
  }
  if (last != kNone) {
    curve.to = crossings.all[at(last)].orderedParameter;
    curve.end = crossings.all[at(last)].point;
  }
  // The parameters may be in the wrong order if the arc has length zero up to rounding.
  if (curve.from > curve.to) curve.from = curve.to = std::sqrt(curve.from) * std::sqrt(curve.to);
  return curve;
}

EdgeCurve ClipParts::curveOf(const Arc& arc) const {
  if (arc.start == kNone && arc.end == kNone) return curveOf(arc.edge);
  const EdgeCurve curve = orderedCurveOf(arc);
  return isOrdered(diagram, arc.edge) ? curve : reversed(curve);
}

EdgeCurve ClipParts::curveOf(const LoopPiece& piece) const {
  const EdgeIndex edge = Diagram::edgeOf(piece.side);
  const EdgeCurve curve = piece.arc == kNone ? orderedCurve(diagram, edge) : orderedCurveOf(arcs.all()[at(piece.arc)]);
  return isOrdered(diagram, edge) == (piece.side % 2 == 0) ? curve : reversed(curve);
}

/// Adds the arcs that follow a crossing where the boundary leaves the cell, up to a crossing where it comes back, which
/// is returned.
std::int32_t ClipParts::addArcs(std::int32_t crossing, Loops& loops) const {
  const Crossing& from = crossings.all[at(crossing)];
  std::int32_t arc = arcs.arcAt(crossing);
  SideIndex side = from.isEntry ? 2 * from.edge : 2 * from.edge + 1;
  Point start = from.point;
  for (;;) {
    const bool isAlongEdge = side % 2 == 0;
    loops.pieces.push_back({start, side, kNone, arc});
    if (arc != kNone) {
      const Arc& its = arcs.all()[at(arc)];
      const std::int32_t other = isAlongEdge ? its.end : its.start;
      if (other != kNone) return other;
    }
    const Vertex& vertex = diagram.vertices[at(diagram.targetOf(side))];
    start = {vertex.x, vertex.y};
    side = diagram.links.nextSide[at(side)];
    const EdgeIndex edge = Diagram::edgeOf(side);
    arc = arcs.isCrossed(edge) ? arcs.atVertex(edge, side % 2 == 0) : kNone;
  }
}

/// Adds the loop that begins with the boundary after a crossing.
void ClipParts::addChain(std::int32_t first, std::vector<std::uint8_t>& isDone, Loops& loops) const {
  const auto into = crossingsInto(cellAfter(crossings.all[at(first)]));
  std::int32_t crossing = first;
  do {
    isDone[at(placesInto_[at(crossing)]) - static_cast<std::size_t>(into.data() - into_.data())] = 1;
    const Stretch stretch = stretchFrom(crossing);
    Point p = crossings.all[at(crossing)].point;
    visitCorners(stretch, [&](RegionSideIndex side) {
      const Point corner = pointOf(sideAfter(side));
      if (p != corner) loops.pieces.push_back({p, kNone, side});
      p = corner;
    });
    const Crossing& to = crossings.all[at(stretch.to)];
    if (p != to.point) loops.pieces.push_back({p, kNone, to.side});
    crossing = addArcs(stretch.to, loops);
  } while (crossing != first);
}

/// Whether all of the border of a cell lies in the region.
bool ClipParts::isBorderInside(CircleIndex circle) const {
  const auto sides = diagram.sides(circle);
  return !sides.empty() && std::ranges::all_of(sides, [&](SideIndex side) {
    return arcs.isInside(diagram.originOf(side)) && !arcs.isCrossed(Diagram::edgeOf(side));
  });
}

void ClipParts::loopsOf(CircleIndex circle, Loops& loops) const {
  loops.clear();
  if (placeOf(circle) == Place::outside) return;
  const auto into = crossingsInto(circle);
  const auto end = [&](bool isHole) {
    loops.offsets.push_back(static_cast<std::int32_t>(loops.pieces.size()));
    loops.isHole.push_back(isHole ? 1 : 0);
  };
  // The polygon of each loop; -1 for a whole border, which lies in one polygon.
  std::vector<std::int32_t> polygons;
  const auto polygonOfSide = [&](RegionSideIndex side) { return region.polygonOf(region.ringOf(side)); };
  std::vector<std::uint8_t> isDone(into.size(), 0);
  for (std::size_t k = 0; k < into.size(); ++k) {
    if (isDone[k] != 0) continue;
    addChain(into[k].index, isDone, loops);
    end(false);
    polygons.push_back(polygonOfSide(crossings.all[at(into[k].index)].side));
  }
  // The border of a whole cell, which may have holes.
  if (isBorderInside(circle)) {
    std::vector<SideIndex> sides;
    orderedSides(diagram, circle, sides);
    for (const SideIndex side : sides) {
      const Vertex& vertex = diagram.vertices[at(diagram.originOf(side))];
      loops.pieces.push_back({{vertex.x, vertex.y}, side});
    }
    end(false);
    polygons.push_back(-1);
  }
  const auto rings = ringsIn(circle);
  if (rings.empty()) return;
  const auto addRing = [&](std::int32_t ring) {
    for (std::int32_t k = region.ringOffsets()[at(ring)]; k < region.ringOffsets()[at(ring) + 1]; ++k) {
      loops.pieces.push_back({pointOf(k), kNone, k});
    }
  };
  std::vector<std::int32_t> holes;
  for (const InCell& one : rings) {
    const std::int32_t polygon = region.polygonOf(one.index);
    if (region.polygonOffsets()[at(polygon)] != one.index) {
      holes.push_back(one.index);
      continue;
    }
    addRing(one.index);
    end(false);
    polygons.push_back(polygon);
  }
  if (holes.empty()) return;
  const std::vector<std::vector<std::int32_t>> holesOf = holesIn(circle, loops, polygons, holes);
  const Loops outer = std::move(loops);
  loops.clear();
  for (std::size_t k = 0; k < polygons.size(); ++k) {
    const auto pieces = outer.loop(k);
    loops.pieces.insert(loops.pieces.end(), pieces.begin(), pieces.end());
    end(false);
    for (const std::int32_t hole : holesOf[k]) {
      addRing(hole);
      end(true);
    }
  }
}

/// Returns for each loop the holes in it. `polygons` has the polygon of each loop, or -1 for a whole border.
std::vector<std::vector<std::int32_t>> ClipParts::holesIn(CircleIndex circle, const Loops& loops,
                                                          const std::vector<std::int32_t>& polygons,
                                                          const std::vector<std::int32_t>& holes) const {
  std::vector<std::vector<std::int32_t>> result(polygons.size());
  // The loops by polygons, with the whole border first.
  std::vector<std::int32_t> order(polygons.size());
  std::iota(order.begin(), order.end(), 0);
  const auto polygonOf = [&](std::int32_t loop) { return polygons[at(loop)]; };
  std::ranges::stable_sort(order, {}, polygonOf);
  const auto borders = withKey(order, std::int32_t{-1}, polygonOf);
  // Holes are sorted by polygons.
  for (std::size_t first = 0, last = 0; first < holes.size(); first = last) {
    const std::int32_t polygon = region.polygonOf(holes[first]);
    std::vector<PointRing> rings;
    for (; last < holes.size() && region.polygonOf(holes[last]) == polygon; ++last) {
      const auto begin = region.points().begin();
      rings.emplace_back(begin + region.ringOffsets()[at(holes[last])],
                         begin + region.ringOffsets()[at(holes[last]) + 1]);
    }
    const auto its = withKey(order, polygon, polygonOf);
    // The polygon of a whole border has no other loop in the cell.
    const auto candidates = its.empty() ? borders : its;
    // Where the region is thinner than rounding, nothing may be left around a hole.
    if (candidates.empty()) continue;
    Outline outer;
    for (std::size_t k = 0; candidates.size() > 1 && k < candidates.size(); ++k) {
      outer.push_back(piecesOf(loops.loop(at(candidates[k]))));
    }
    const std::vector<std::size_t> around = loopsAround(outer, rings, middleOf(circle, outer));
    for (std::size_t k = 0; k < rings.size(); ++k) result[at(candidates[around[k]])].push_back(holes[first + k]);
  }
  return result;
}

/// For Metric::power, whose centers may lie outside, it is the mean of points of the cell, which is convex.
Point ClipParts::middleOf(CircleIndex circle, const Outline& loops) const {
  const Circle& c = diagram.circles[at(circle)];
  if (diagram.metric != Metric::power) return {c.x, c.y};
  Point sum = {0, 0};
  std::size_t count = 0;
  for (const auto& loop : loops) {
    for (const OutlinePiece& piece : loop) {
      sum = {sum.x + piece.curve.start.x, sum.y + piece.curve.start.y};
      ++count;
    }
  }
  return {sum.x / static_cast<double>(count), sum.y / static_cast<double>(count)};
}

std::vector<OutlinePiece> ClipParts::piecesOf(std::span<const LoopPiece> loop) const {
  std::vector<OutlinePiece> pieces;
  pieces.reserve(loop.size());
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const LoopPiece& piece = loop[k];
    if (piece.side == kNone) {
      const Point end = loop[k + 1 == loop.size() ? 0 : k + 1].start;
      pieces.push_back({segment(piece.start, end), kNone, kNone, 0, piece.regionSide});
    } else {
      pieces.push_back({curveOf(piece), piece.side, diagram.neighborOf(piece.side)});
    }
  }
  return pieces;
}

}  // namespace circle_voronoi
