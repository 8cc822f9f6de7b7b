// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_moments.h"

#include <cmath>
#include <limits>
#include <utility>

#include "at.h"
#include "clip_parts.h"
#include "compensated_sum.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

using Parts = ClippedDiagram::Parts;
using Place = ClippedDiagram::Place;

Point placeOf(const Vertex& vertex) { return {vertex.x, vertex.y}; }

/// Adds up the moments of all cells.
///
/// The sum of areas is that of the region to rounding, though points on the boundary are rounded: a crossing counts as
/// the point that divides its side of the region exactly as Crossing::share says, seen from nearby.
class Adder {
 public:
  /// Calls `visit`, if there is one, with each part of an edge inside.
  Adder(const Parts& parts, const VisitArc& visit)
      : parts_(parts),
        diagram_(parts.diagram),
        moments_(diagram_.circles.size()),
        references_(diagram_.circles.size()) {
    chooseReferences();
    addEdges(visit);
    addArcs(visit);
    addBoundary();
  }

  CellMoments run() {
    // If only some cells are clipped, the sums of the other cells are not complete.
    for (std::size_t i = 0; i < moments_.size(); ++i) {
      if (parts_.placeOf(static_cast<std::int32_t>(i)) == Place::outside) moments_[i] = {};
    }
    return {std::move(moments_), std::move(references_)};
  }

 private:
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

  Vector seen(CircleIndex cell, Point p) const { return vectorTo(references_[at(cell)], p); }

  Vector seen(CircleIndex cell, const Crossing& crossing) const {
    Point from = parts_.pointOf(crossing.side);
    Point to = parts_.pointOf(parts_.sideAfter(crossing.side));
    if (to.x < from.x || (to.x == from.x && to.y < from.y)) std::swap(from, to);
    const Vector u = seen(cell, from);
    const Vector along = vectorTo(from, to);
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

  void addEdges(const VisitArc& visit) {
    for (std::size_t e = 0; e < diagram_.edges.size(); ++e) {
      const auto index = static_cast<std::int32_t>(e);
      const Edge& edge = diagram_.edges[e];
      // If only some cells are clipped, edges of the others may go to infinity without crossings.
      if (parts_.arcs.isCrossed(index) || !parts_.arcs.isInside(edge.start) || edge.end == kNone) continue;
      addArc({index}, visit);
    }
  }

  void addArcs(const VisitArc& visit) {
    for (const Arc& arc : parts_.arcs.all()) addArc(arc, visit);
  }

  void addArc(const Arc& arc, const VisitArc& visit) {
    const Edge& edge = diagram_.edges[at(arc.edge)];
    const EdgeCurve curve = parts_.curveOf(arc);
    if (visit) visit(edge, curve);
    const auto seenEnd = [&](CircleIndex cell, std::int32_t crossing, VertexIndex vertex) {
      return crossing == kNone ? seen(cell, placeOf(diagram_.vertices[at(vertex)]))
                               : seen(cell, parts_.crossings.all[at(crossing)]);
    };
    const Moments beyond = curve.isStraight() ? Moments() : momentsOverChord(curve, curve.start);
    for (const CircleIndex cell : {edge.left, edge.right}) {
      const double factor = cell == edge.left ? 1 : -1;
      const Vector start = seenEnd(cell, arc.start, edge.start);
      addTriangle(cell, start, seenEnd(cell, arc.end, edge.end), factor);
      add(cell, beyond, start, factor);
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
  std::vector<Moments> moments_;
  std::vector<Point> references_;
};

}  // namespace

Point CellMoments::centroid(std::size_t cell) const {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const auto& [area, x, y] = moments[cell];
  if (!(area > 0)) return {kNaN, kNaN};
  return {references[cell].x + x / area, references[cell].y + y / area};
}

CellMoments momentsOf(const ClippedDiagram::Parts& parts, const VisitArc& visit) { return Adder(parts, visit).run(); }

}  // namespace circle_voronoi
