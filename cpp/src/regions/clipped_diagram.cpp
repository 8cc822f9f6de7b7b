// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/clipped_diagram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_set>

#include "at.h"
#include "cell_limits.h"
#include "check_arrays.h"
#include "circle_arc.h"
#include "clip_parts.h"
#include "clip_polygons.h"
#include "guarded.h"
#include "part_within.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

using Place = ClippedDiagram::Place;

void append(ClippedCells& cells, Point start, SideIndex side, RegionSideIndex regionSide, double r) {
  cells.x.push_back(start.x);
  cells.y.push_back(start.y);
  cells.side.push_back(side);
  cells.regionSide.push_back(regionSide);
  cells.r.push_back(r);
}

void append(ClippedCells& cells, const LoopsWithin& loops) {
  for (std::size_t k = 0; k < loops.outline.size(); ++k) {
    cells.isHole.push_back(loops.isHole[k]);
    for (const OutlinePiece& piece : loops.outline[k]) {
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
    ClipParts::of(clipped).loopsOf(circle, loops);
    if (clipped.maxDistance()) {
      append(cells, loopsWithin(ClipParts::of(clipped), circle, loops));
    } else {
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

/// A value of each circle.
template <class Value, class ValueOf>
std::vector<Value> ofEach(const ClippedDiagram& clipped, ValueOf valueOf) {
  std::vector<Value> values(clipped.diagram().circles.size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = valueOf(static_cast<std::int32_t>(i));
  return values;
}

/// A part of an edge and the sides of the region on which it ends.
struct EdgePart {
  EdgeCurve curve;
  RegionSideIndex startSide;
  RegionSideIndex endSide;
};

template <class Add>
void visitParts(const ClipParts& parts, EdgeIndex edge, Add add) {
  const auto sideOf = [&](std::int32_t crossing) {
    return crossing == kNone ? RegionSideIndex() : parts.crossings.all[at(crossing)].side;
  };
  const auto addArc = [&](const Arc& arc) {
    if (!parts.maxDistance) return add({parts.curveOf(arc), sideOf(arc.start), sideOf(arc.end)});
    const auto near = arcWithin(parts, arc);
    if (!near) return;
    add({near->curve, near->isCutFrom ? RegionSideIndex() : sideOf(arc.start),
         near->isCutTo ? RegionSideIndex() : sideOf(arc.end)});
  };
  if (!parts.arcs.isCrossed(edge)) {
    if (parts.isInside(edge)) addArc({edge});
    return;
  }
  for (const Arc& arc : parts.arcs.of(edge)) addArc(arc);
}

}  // namespace

Result<ClippedDiagram> ClippedDiagram::from(const Diagram& diagram, const Region& region,
                                            std::optional<double> maxDistance) {
  return ClipParts::clip(diagram, region, maxDistance, std::nullopt, {});
}

Result<ClippedDiagram> ClippedDiagram::ofCells(const Diagram& diagram, const Region& region,
                                               std::span<const CircleIndex> circles,
                                               std::optional<double> maxDistance) {
  return ClipParts::clip(diagram, region, maxDistance, circles, {});
}

Result<ClippedDiagram> ClipParts::clip(const Diagram& diagram, const Region& region, std::optional<double> maxDistance,
                                       std::optional<std::span<const CircleIndex>> circles, const VisitArc& visit) {
  return guarded([&]() -> Result<ClippedDiagram> {
    if (auto checked = checkMaxDistance(maxDistance); !checked) return checked.error();
    const auto isMissing = [&](CircleIndex i) { return i < 0 || at(i) >= diagram.circles.size(); };
    if (circles && std::ranges::any_of(*circles, isMissing)) {
      return errorWith(ErrorCode::badInput, "A cell to clip is none of the diagram.");
    }
    if (auto checked = circles ? checkArrays(diagram, *circles) : checkArrays(diagram); !checked) {
      return checked.error();
    }
    return ClippedDiagram(std::make_shared<const ClipParts>(diagram, region, maxDistance, circles, visit));
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
  if (parts_->maxDistance) return loopsWithin(*parts_, circle, loops).outline;
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
  std::unordered_set<CircleIndex> met;
  for (const SideIndex side : diagram().sides(circle)) {
    bool isShared = false;
    visitParts(*parts_, Diagram::edgeOf(side), [&](const EdgePart&) { isShared = true; });
    const CircleIndex neighbor = diagram().neighborOf(side);
    if (isShared && met.insert(neighbor).second) result.push_back(neighbor);
  }
  return result;
}

double ClippedDiagram::area(CircleIndex circle) const {
  if (maxDistance()) return circle_voronoi::area(outline(circle));
  const std::int32_t row = parts_->scope.cells.rowOf(circle);
  return row == kNone ? 0 : parts_->moments.area(at(row));
}

Point ClippedDiagram::centroid(CircleIndex circle) const {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  if (maxDistance()) {
    const Outline its = outline(circle);
    return its.empty() ? Point{kNaN, kNaN} : circle_voronoi::centroid(its);
  }
  const std::int32_t row = parts_->scope.cells.rowOf(circle);
  return row == kNone ? Point{kNaN, kNaN} : parts_->moments.centroid(at(row));
}

double ClippedDiagram::perimeter(CircleIndex circle) const { return circle_voronoi::perimeter(outline(circle)); }

std::vector<double> ClippedDiagram::areas() const {
  return ofEach<double>(*this, [this](CircleIndex circle) { return area(circle); });
}

std::vector<Point> ClippedDiagram::centroids() const {
  return ofEach<Point>(*this, [this](CircleIndex circle) { return centroid(circle); });
}

std::vector<double> ClippedDiagram::perimeters() const {
  return ofEach<double>(*this, [this](CircleIndex circle) { return perimeter(circle); });
}

std::optional<EmptyDisc> ClippedDiagram::largestEmptyDisc() const {
  std::optional<EmptyDisc> best;
  const auto offer = [&](const Vertex& disc, const std::array<CircleIndex, 3>& circles) {
    if (!best || disc.r > best->disc.r) best = {disc, circles};
  };
  const auto offerPoint = [&](Point p, CircleIndex circle, CircleIndex other) {
    offer({p.x, p.y, distanceFrom(diagram(), circle, p)}, {circle, other, kNone});
  };
  const ClipParts& parts = *parts_;
  for (std::size_t row = 0; row < parts.scope.vertices.size(); ++row) {
    const VertexIndex vertex = parts.scope.vertices[row];
    if (parts.arcs.isInside(vertex)) offer(diagram().vertices[at(vertex)], diagram().vertexCircles[at(vertex)]);
  }
  const auto& all = parts.crossings.all;
  for (const auto& [cell, crossing] : parts.allCrossings()) {
    const Edge& edge = diagram().edges[at(all[at(crossing)].edge)];
    offerPoint(all[at(crossing)].point, edge.left, edge.right);
    parts.visitCorners(parts.stretchFrom(crossing), [&, own = cell](RegionSideIndex side) {
      offerPoint(parts.pointOf(parts.sideAfter(side)), own, kNone);
    });
  }
  for (const auto& [cell, ring] : parts.allRings()) {
    for (std::int32_t k = region().ringOffsets()[at(ring)]; k < region().ringOffsets()[at(ring) + 1]; ++k) {
      offerPoint(parts.pointOf(k), cell, kNone);
    }
  }
  return best;
}

ClippedPolygons ClippedDiagram::polygons(double tolerance) const {
  return clipPolygons(*this, Chosen(diagram().circles.size()), tolerance);
}

}  // namespace circle_voronoi
