// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/clipped_diagram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "arc_measure.h"
#include "areas_and_arcs.h"
#include "at.h"
#include "cell_limits.h"
#include "check_arrays.h"
#include "circle_arc.h"
#include "clip_parts.h"
#include "clip_polygons.h"
#include "compensated_sum.h"
#include "guarded.h"
#include "near_part.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

using Parts = ClippedDiagram::Parts;
using Place = ClippedDiagram::Place;

using VisitArc = std::function<void(const Edge&, const EdgeCurve&)>;

Point placeOf(const Vertex& vertex) { return {vertex.x, vertex.y}; }

/// The moments of the parts of all cells in the region, each relative to a point of its own.
///
/// The sum of areas is that of the region to rounding, though points on the boundary are rounded: a crossing counts as
/// the point that divides its side of the region exactly as Crossing::share says, seen from nearby.
class CellMoments {
 public:
  /// Calls `visit`, if there is one, with each part of an edge inside.
  explicit CellMoments(const Parts& parts, const VisitArc& visit = {})
      : parts_(parts),
        diagram_(parts.diagram),
        moments_(diagram_.circles.size()),
        references_(diagram_.circles.size()) {
    const Box& box = parts.bounds;
    unit_ = unitFor(std::max(box.maxX - box.minX, box.maxY - box.minY));
    chooseReferences();
    addEdges(visit);
    addArcs(visit);
    addBoundary();
  }

  double area(std::size_t cell) const { return isOutside(cell) ? 0 : moments_[cell].area * unit_ * unit_; }

  Point centroid(std::size_t cell) const {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    const auto& [area, x, y] = moments_[cell];
    if (isOutside(cell) || !(area > 0)) return {kNaN, kNaN};
    return {references_[cell].x + unit_ * (x / area), references_[cell].y + unit_ * (y / area)};
  }

 private:
  /// Of some cells only, the others have sums that are not complete.
  bool isOutside(std::size_t cell) const { return parts_.placeOf(static_cast<std::int32_t>(cell)) == Place::outside; }

  /// Points near the parts: the centers of circles, but for cells that they may lie outside of.
  void chooseReferences() {
    for (std::size_t i = 0; i < references_.size(); ++i) {
      const auto circle = static_cast<std::int32_t>(i);
      references_[i] = {diagram_.circles[i].x, diagram_.circles[i].y};
      const Place place = parts_.placeOf(circle);
      if (place == Place::inside && diagram_.metric == Metric::power) {
        references_[i] = placeOf(diagram_.vertices[at(diagram_.originOf(diagram_.links.firstSide[i]))]);
      }
      if (place != Place::cut) continue;
      const auto into = parts_.crossingsInto(circle);
      const auto rings = parts_.ringsIn(circle);
      if (!into.empty()) {
        references_[i] = parts_.crossings.all[at(into[0].index)].point;
      } else if (!rings.empty()) {
        references_[i] = parts_.pointOf(parts_.region.ringOffsets()[at(rings[0].index)]);
      } else {
        references_[i] = placeOf(diagram_.vertices[at(diagram_.originOf(diagram_.links.firstSide[i]))]);
      }
    }
  }

  Vector seen(CircleIndex cell, Point p) const { return measuredIn(unit_, vectorTo(references_[at(cell)], p)); }

  Vector seen(CircleIndex cell, const Crossing& crossing) const {
    Point from = parts_.pointOf(crossing.side);
    Point to = parts_.pointOf(parts_.sideAfter(crossing.side));
    if (to.x < from.x || (to.x == from.x && to.y < from.y)) std::swap(from, to);
    const Vector u = seen(cell, from);
    const Vector along = measuredIn(unit_, vectorTo(from, to));
    return {u.x + crossing.share * along.x, u.y + crossing.share * along.y};
  }

  void addTriangle(CircleIndex cell, Vector u, Vector v, double factor) {
    const double area = factor * cross(u, v) / 2;
    Moments& sum = moments_[at(cell)];
    sum.area += area;
    sum.x += area * (u.x + v.x) / 3;
    sum.y += area * (u.y + v.y) / 3;
  }

  /// Adds moments relative to a point.
  void add(CircleIndex cell, const Moments& moments, Vector reference, double factor) {
    Moments& sum = moments_[at(cell)];
    sum.area += factor * moments.area;
    sum.x += factor * (moments.x + moments.area * reference.x);
    sum.y += factor * (moments.y + moments.area * reference.y);
  }

  template <class End>
  void addCurve(const Edge& edge, const EdgeCurve& curve, const End& start, const End& end, double factor) {
    for (const CircleIndex cell : {edge.left, edge.right}) {
      addTriangle(cell, seen(cell, start), seen(cell, end), cell == edge.left ? factor : -factor);
    }
    if (curve.isStraight()) return;
    const Moments beyond = momentsOverChord(curve, curve.start, unit_);
    add(edge.left, beyond, seen(edge.left, curve.start), factor);
    add(edge.right, beyond, seen(edge.right, curve.start), -factor);
  }

  void addEdges(const VisitArc& visit) {
    for (std::size_t e = 0; e < diagram_.edges.size(); ++e) {
      const auto index = static_cast<std::int32_t>(e);
      const Edge& edge = diagram_.edges[e];
      if (parts_.arcs.isCrossed(index)) continue;
      const std::int32_t level = parts_.arcs.levelOf(edge.start);
      // If only some cells are clipped, edges of the others may go to infinity without crossings.
      if (level == 0 || edge.end == kNone) continue;
      const Point start = placeOf(diagram_.vertices[at(edge.start)]);
      const Point end = placeOf(diagram_.vertices[at(edge.end)]);
      const EdgeCurve curve = parts_.curveOf(index);
      if (visit && level > 0) visit(edge, curve);
      addCurve(edge, curve, start, end, level);
    }
  }

  void addArcs(const VisitArc& visit) {
    for (const Arc& arc : parts_.arcs.all()) {
      const Edge& edge = diagram_.edges[at(arc.edge)];
      const double factor = arc.layer > 0 ? 1 : -1;
      const EdgeCurve curve = parts_.curveOf(arc);
      if (visit && arc.layer == 1) visit(edge, curve);
      struct End {
        const CellMoments& its;
        std::int32_t crossing;
        VertexIndex vertex;
        Vector from(CircleIndex cell) const {
          return crossing == kNone ? its.seen(cell, placeOf(its.diagram_.vertices[at(vertex)]))
                                   : its.seen(cell, its.parts_.crossings.all[at(crossing)]);
        }
      };
      const End start = {*this, arc.start, edge.start};
      const End end = {*this, arc.end, edge.end};
      for (const CircleIndex cell : {edge.left, edge.right}) {
        addTriangle(cell, start.from(cell), end.from(cell), cell == edge.left ? factor : -factor);
      }
      if (curve.isStraight()) continue;
      const Moments beyond = momentsOverChord(curve, curve.start, unit_);
      add(edge.left, beyond, start.from(edge.left), factor);
      add(edge.right, beyond, start.from(edge.right), -factor);
    }
  }

  void addBoundary() {
    const auto& all = parts_.crossings.all;
    for (const auto& [cell, crossing] : parts_.allCrossings()) {
      const auto stretch = parts_.stretchFrom(crossing);
      Vector last = seen(cell, all[at(crossing)]);
      addChain(cell, [&, cell = cell](auto visit) {
        parts_.visitCorners(stretch, [&](RegionSideIndex side) {
          const Vector next = seen(cell, parts_.pointOf(parts_.sideAfter(side)));
          visit(last, next);
          last = next;
        });
        visit(last, seen(cell, all[at(stretch.to)]));
      });
    }
    for (const auto& [cell, ring] : parts_.allRings()) {
      const std::int32_t begin = parts_.region.ringOffsets()[at(ring)];
      const std::int32_t end = parts_.region.ringOffsets()[at(ring) + 1];
      addChain(cell, [&, cell = cell](auto visit) {
        Vector last = seen(cell, parts_.pointOf(end - 1));
        for (std::int32_t k = begin; k < end; ++k) {
          const Vector next = seen(cell, parts_.pointOf(k));
          visit(last, next);
          last = next;
        }
      });
    }
  }

  /// Adds triangles of which there may be very many in one cell.
  template <class VisitAll>
  void addChain(CircleIndex cell, VisitAll visitAll) {
    CompensatedSum area;
    CompensatedSum x;
    CompensatedSum y;
    visitAll([&](Vector u, Vector v) {
      const double its = cross(u, v) / 2;
      area += its;
      x += its * (u.x + v.x) / 3;
      y += its * (u.y + v.y) / 3;
    });
    Moments& sum = moments_[at(cell)];
    sum.area += area.value();
    sum.x += x.value();
    sum.y += y.value();
  }

  const Parts& parts_;
  const Diagram& diagram_;
  double unit_ = 1;
  std::vector<Moments> moments_;
  std::vector<Point> references_;
};

void append(ClippedCells& cells, Point start, SideIndex side, RegionSideIndex regionSide, double r) {
  cells.x.push_back(start.x);
  cells.y.push_back(start.y);
  cells.side.push_back(side);
  cells.regionSide.push_back(regionSide);
  cells.r.push_back(r);
}

/// Whether a loop runs clockwise.
bool isHoleOf(const std::vector<OutlinePiece>& loop) { return area({loop}) < 0; }

void append(ClippedCells& cells, const Outline& outline) {
  for (std::size_t k = 0; k < outline.size(); ++k) {
    cells.isHole.push_back(k > 0 && isHoleOf(outline[k]) ? 1 : 0);
    for (const OutlinePiece& piece : outline[k]) {
      append(cells, piece.curve.start, piece.side, piece.regionSide, piece.r);
    }
    cells.pieceOffsets.push_back(static_cast<std::int32_t>(cells.x.size()));
  }
  cells.loopOffsets.push_back(static_cast<std::int32_t>(cells.isHole.size()));
}

void append(ClippedCells& cells, const Loops& loops) {
  for (std::size_t k = 0; k < loops.isHole.size(); ++k) {
    cells.isHole.push_back(loops.isHole[k]);
    for (const LoopPiece& piece : loops.loop(k)) append(cells, piece.start, piece.side, piece.regionSide, 0);
    cells.pieceOffsets.push_back(static_cast<std::int32_t>(cells.x.size()));
  }
  cells.loopOffsets.push_back(static_cast<std::int32_t>(cells.isHole.size()));
}

template <class Circles>
ClippedCells cellsOf(const ClippedDiagram& clipped, const Circles& circles) {
  ClippedCells cells;
  Loops loops;
  for (const CircleIndex circle : circles) {
    if (clipped.maxDistance()) {
      append(cells, clipped.outline(circle));
    } else {
      clipped.parts().loopsOf(circle, loops);
      append(cells, loops);
    }
  }
  return cells;
}

std::vector<CircleIndex> allOf(const Diagram& diagram) {
  std::vector<CircleIndex> circles(diagram.circles.size());
  for (std::size_t i = 0; i < circles.size(); ++i) circles[i] = static_cast<std::int32_t>(i);
  return circles;
}

/// A part of an edge and the sides of the region on which it ends.
struct EdgePart {
  EdgeCurve curve;
  RegionSideIndex startSide;
  RegionSideIndex endSide;
};

template <class Add>
void visitParts(const Parts& parts, EdgeIndex edge, Add add) {
  const auto addNear = [&](EdgePart part) {
    if (!parts.maxDistance) return add(part);
    const auto near = nearPart(parts.diagram, edge, part.curve, *parts.maxDistance);
    if (!near) return;
    if (near->cutFrom != kNone) part.startSide = kNone;
    if (near->cutTo != kNone) part.endSide = kNone;
    part.curve = near->curve;
    add(part);
  };
  if (!parts.arcs.isCrossed(edge)) {
    if (parts.arcs.isInside(edge)) addNear({parts.curveOf(edge), kNone, kNone});
    return;
  }
  const auto sideOf = [&](std::int32_t crossing) {
    return crossing == kNone ? RegionSideIndex() : parts.crossings.all[at(crossing)].side;
  };
  std::vector<Arc> arcs;
  for (const Arc& arc : parts.arcs.of(edge)) {
    if (arc.layer == 1) arcs.push_back(arc);
  }
  const auto parameter = [&](const Arc& arc) {
    return arc.start == kNone ? 0 : parts.crossings.all[at(arc.start)].parameter;
  };
  std::ranges::stable_sort(arcs, {}, parameter);
  for (const Arc& arc : arcs) addNear({parts.curveOf(arc), sideOf(arc.start), sideOf(arc.end)});
}

}  // namespace

Result<ClippedDiagram> ClippedDiagram::from(const Diagram& diagram, const Region& region,
                                            std::optional<double> maxDistance) {
  return make(diagram, region, maxDistance, std::nullopt);
}

Result<ClippedDiagram> ClippedDiagram::ofCells(const Diagram& diagram, const Region& region,
                                               std::span<const CircleIndex> circles,
                                               std::optional<double> maxDistance) {
  return make(diagram, region, maxDistance, circles);
}

Result<ClippedDiagram> ClippedDiagram::make(const Diagram& diagram, const Region& region,
                                            std::optional<double> maxDistance,
                                            std::optional<std::span<const CircleIndex>> circles) {
  return guarded([&]() -> Result<ClippedDiagram> {
    if (auto checked = checkMaxDistance(maxDistance); !checked) return checked.error();
    if (maxDistance && diagram.metric == Metric::power) {
      return errorWith(ErrorCode::badOption, "A power diagram has no maximum distance.");
    }
    if (auto checked = checkArrays(diagram); !checked) return checked.error();
    const auto isMissing = [&](CircleIndex i) { return i < 0 || at(i) >= diagram.circles.size(); };
    if (circles && std::ranges::any_of(*circles, isMissing)) {
      return errorWith(ErrorCode::badInput, "A cell to clip is none of the diagram.");
    }
    return ClippedDiagram(std::make_shared<const Parts>(diagram, region, maxDistance, circles));
  });
}

const Diagram& ClippedDiagram::diagram() const { return parts_->diagram; }
const Region& ClippedDiagram::region() const { return parts_->region; }
std::optional<double> ClippedDiagram::maxDistance() const { return parts_->maxDistance; }

ClippedDiagram::Place ClippedDiagram::placeOf(CircleIndex circle) const {
  const Place place = parts_->placeOf(circle);
  return place == Place::inside && parts_->maxDistance ? Place::cut : place;
}

Outline ClippedDiagram::outline(CircleIndex circle) const {
  Loops loops;
  parts_->loopsOf(circle, loops);
  if (parts_->maxDistance) return nearOutline(*parts_, circle, loops);
  Outline outline;
  for (std::size_t k = 0; k < loops.isHole.size(); ++k) outline.push_back(parts_->piecesOf(loops.loop(k)));
  return outline;
}

ClippedCells ClippedDiagram::cells() const { return cellsOf(*this, allOf(diagram())); }
ClippedCells ClippedDiagram::cells(std::span<const CircleIndex> circles) const { return cellsOf(*this, circles); }

std::vector<EdgeCurve> ClippedDiagram::edgeParts(EdgeIndex edge) const {
  std::vector<EdgeCurve> curves;
  visitParts(*parts_, edge, [&](const EdgePart& part) { curves.push_back(part.curve); });
  return curves;
}

ClippedEdges ClippedDiagram::edges() const {
  ClippedEdges edges;
  for (EdgeIndex e = 0; e < static_cast<std::int32_t>(diagram().edges.size()); ++e) {
    visitParts(*parts_, e, [&](const EdgePart& part) {
      edges.edge.push_back(e);
      edges.from.push_back(part.curve.from);
      edges.to.push_back(part.curve.to);
      edges.start.push_back(part.curve.start);
      edges.end.push_back(part.curve.end);
      edges.startSide.push_back(part.startSide);
      edges.endSide.push_back(part.endSide);
    });
  }
  return edges;
}

std::vector<CircleIndex> ClippedDiagram::neighbors(CircleIndex circle) const {
  std::vector<CircleIndex> result;
  for (const SideIndex side : diagram().sides(circle)) {
    const CircleIndex neighbor = diagram().neighborOf(side);
    if (std::ranges::find(result, neighbor) != result.end()) continue;
    bool isShared = false;
    visitParts(*parts_, Diagram::edgeOf(side), [&](const EdgePart&) { isShared = true; });
    if (isShared) result.push_back(neighbor);
  }
  return result;
}

std::vector<double> ClippedDiagram::areas() const {
  if (!maxDistance()) return areasAndArcs(*this, {});
  std::vector<double> areas(diagram().circles.size());
  for (std::size_t i = 0; i < areas.size(); ++i) areas[i] = area(outline(static_cast<std::int32_t>(i)));
  return areas;
}

std::vector<double> areasAndArcs(const ClippedDiagram& clipped, const VisitArc& visit) {
  const CellMoments moments(clipped.parts(), visit);
  std::vector<double> areas(clipped.diagram().circles.size());
  for (std::size_t i = 0; i < areas.size(); ++i) areas[i] = moments.area(i);
  return areas;
}

std::vector<Point> ClippedDiagram::centroids() const {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  std::vector<Point> centroids(diagram().circles.size());
  if (!maxDistance()) {
    const CellMoments moments(*parts_);
    for (std::size_t i = 0; i < centroids.size(); ++i) centroids[i] = moments.centroid(i);
    return centroids;
  }
  for (std::size_t i = 0; i < centroids.size(); ++i) {
    const Outline its = outline(static_cast<std::int32_t>(i));
    centroids[i] = its.empty() ? Point{kNaN, kNaN} : centroid(its);
  }
  return centroids;
}

std::vector<double> ClippedDiagram::perimeters() const {
  std::vector<double> perimeters(diagram().circles.size());
  for (std::size_t i = 0; i < perimeters.size(); ++i) perimeters[i] = perimeter(outline(static_cast<std::int32_t>(i)));
  return perimeters;
}

std::optional<EmptyDisc> ClippedDiagram::largestEmptyDisc() const {
  std::optional<EmptyDisc> best;
  const auto offer = [&](const Vertex& disc, const std::array<CircleIndex, 3>& circles) {
    if (!best || disc.r > best->disc.r) best = {disc, circles};
  };
  const auto offerPoint = [&](Point p, CircleIndex circle, CircleIndex other) {
    offer({p.x, p.y, distanceFrom(diagram(), circle, p)}, {circle, other, kNone});
  };
  const Parts& parts = *parts_;
  for (std::size_t v = 0; v < diagram().vertices.size(); ++v) {
    const auto vertex = static_cast<std::int32_t>(v);
    if (parts.arcs.levelOf(vertex) > 0) offer(diagram().vertices[v], diagram().vertexCircles[v]);
  }
  const auto& all = parts.crossings.all;
  for (const auto& [cell, crossing] : parts.allCrossings()) {
    const Edge& edge = diagram().edges[at(all[at(crossing)].edge)];
    offerPoint(all[at(crossing)].point, edge.left, edge.right);
    parts.visitCorners(parts.stretchFrom(crossing), [&, cell = cell](RegionSideIndex side) {
      offerPoint(parts.pointOf(parts.sideAfter(side)), cell, kNone);
    });
  }
  for (const auto& [cell, ring] : parts.allRings()) {
    for (std::int32_t k = region().ringOffsets()[at(ring)]; k < region().ringOffsets()[at(ring) + 1]; ++k) {
      offerPoint(parts.pointOf(k), cell, kNone);
    }
  }
  return best;
}

ClippedPolygons ClippedDiagram::polygons(double tolerance) const { return clipPolygons(*this, tolerance); }

}  // namespace circle_voronoi
