// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_moments.h"

#include <cmath>
#include <limits>
#include <utility>

#include "at.h"
#include "clip_parts.h"
#include "compensated_sum.h"
#include "edge_curve.h"
#include "ordered_sides.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

using Place = ClippedDiagram::Place;

Point placeOf(const Vertex& vertex) { return {vertex.x, vertex.y}; }

/// Adds up the moments of the cells of a clip.
///
/// The sum of areas is that of the region to rounding, though points on the boundary are rounded: a crossing counts as
/// the point that divides its side of the region exactly as Crossing::share says, seen from nearby. Each cell adds its
/// sides and stretches of the boundary in an order that depends on its circles alone, so a cell has the same bits
/// whatever other cells are clipped.
class Adder {
 public:
  /// Calls `visit`, if there is one, with each part of an edge inside.
  Adder(const ClipParts& parts, const VisitArc& visit)
      : parts_(parts),
        diagram_(parts.diagram),
        moments_(parts.scope.cells.size()),
        references_(parts.scope.cells.size()) {
    findArcs(visit);
    for (row_ = 0; row_ < moments_.size(); ++row_) {
      cell_ = parts_.scope.cells[row_];
      const Place place = parts_.placeOf(cell_);
      references_[row_] = {diagram_.circles[at(cell_)].x, diagram_.circles[at(cell_)].y};
      if (place == Place::outside) continue;
      orderedSides(diagram_, cell_, sides_);
      chooseReference(place);
      for (const SideIndex side : sides_) addSide(side);
      addBoundary();
    }
  }

  CellMoments run() { return {std::move(moments_), std::move(references_), boundary_.value()}; }

 private:
  /// Finds the moments over the chords of all parts of edges inside, once for both cells.
  void findArcs(const VisitArc& visit) {
    const Chosen& edges = parts_.scope.edges;
    overWhole_.resize(edges.size());
    overArc_.resize(parts_.arcs.all().size());
    const auto find = [&](EdgeIndex edge, const EdgeCurve& curve) {
      if (visit) visit(diagram_.edges[at(edge)], isOrdered(diagram_, edge) ? curve : reversed(curve));
      return curve.isStraight() ? Moments() : momentsOverChord(curve, curve.start);
    };
    for (std::size_t row = 0; row < edges.size(); ++row) {
      const EdgeIndex edge = edges[row];
      if (isWholeInside(edge)) overWhole_[row] = find(edge, orderedCurve(diagram_, edge));
    }
    for (std::size_t k = 0; k < overArc_.size(); ++k) {
      const Arc& arc = parts_.arcs.all()[k];
      overArc_[k] = find(arc.edge, parts_.orderedCurveOf(arc));
    }
  }

  /// If only some cells are clipped, edges of the others may go to infinity without crossings.
  bool isWholeInside(EdgeIndex edge) const {
    return !parts_.arcs.isCrossed(edge) && parts_.isInside(edge) && diagram_.edges[at(edge)].end != kNone;
  }

  /// A point near the part: the center of the circle, but for a cell that it may lie outside of.
  void chooseReference(Place place) {
    if (place == Place::inside && diagram_.metric != Metric::power) return;
    const auto into = parts_.crossingsInto(cell_);
    const auto rings = parts_.ringsIn(cell_);
    if (place == Place::cut && !into.empty()) {
      references_[row_] = parts_.crossings.all[at(into[0].index)].point;
    } else if (place == Place::cut && !rings.empty()) {
      references_[row_] = parts_.pointOf(parts_.region.ringOffsets()[at(rings[0].index)]);
    } else {
      references_[row_] = placeOf(diagram_.vertices[at(diagram_.originOf(sides_.front()))]);
    }
  }

  Vector seen(Point p) const { return vectorTo(references_[row_], p); }

  Vector seen(const Crossing& crossing) const {
    Point from = parts_.pointOf(crossing.side);
    Point to = parts_.pointOf(parts_.sideAfter(crossing.side));
    if (to.x < from.x || (to.x == from.x && to.y < from.y)) std::swap(from, to);
    const Vector u = seen(from);
    const Vector along = vectorTo(from, to);
    return {u.x + crossing.share * along.x, u.y + crossing.share * along.y};
  }

  void addTriangle(Vector u, Vector v) {
    const double area = cross(u, v) / 2;
    Moments& sum = moments_[row_];
    sum.area += area;
    sum.x += area * (u.x + v.x) / 3;
    sum.y += area * (u.y + v.y) / 3;
  }

  /// Adds moments relative to a point.
  void add(const Moments& moments, Vector reference, double factor) {
    Moments& sum = moments_[row_];
    sum.area += factor * moments.area;
    sum.x += factor * (moments.x + moments.area * reference.x);
    sum.y += factor * (moments.y + moments.area * reference.y);
  }

  /// Adds the parts of a side inside, in the direction of the side.
  void addSide(SideIndex side) {
    const EdgeIndex edge = Diagram::edgeOf(side);
    if (!parts_.arcs.isCrossed(edge)) {
      if (isWholeInside(edge)) addArc(side, {edge}, overWhole_[at(parts_.scope.edges.rowOf(edge))]);
      return;
    }
    const auto arcs = parts_.arcs.of(edge);
    const auto first = static_cast<std::size_t>(arcs.data() - parts_.arcs.all().data());
    for (std::size_t k = 0; k < arcs.size(); ++k) {
      const std::size_t place = side % 2 == 0 ? k : arcs.size() - 1 - k;
      addArc(side, arcs[place], overArc_[first + place]);
    }
  }

  void addArc(SideIndex side, const Arc& arc, const Moments& overChord) {
    const Edge& edge = diagram_.edges[at(arc.edge)];
    const auto seenEnd = [&](std::int32_t crossing, VertexIndex vertex) {
      return crossing == kNone ? seen(placeOf(diagram_.vertices[at(vertex)]))
                               : seen(parts_.crossings.all[at(crossing)]);
    };
    Vector start = seenEnd(arc.start, edge.start);
    Vector end = seenEnd(arc.end, edge.end);
    if (side % 2 != 0) std::swap(start, end);
    addTriangle(start, end);
    // The moments over the chord are those for the circle on the left of orderedCurve, from where its side begins.
    const bool isFirst = isOrdered(diagram_, arc.edge) == (side % 2 == 0);
    add(overChord, isFirst ? start : end, isFirst ? 1 : -1);
  }

  void addBoundary() {
    const auto& all = parts_.crossings.all;
    for (const auto& [cell, crossing] : parts_.crossingsInto(cell_)) {
      const auto stretch = parts_.stretchFrom(crossing);
      Vector last = seen(all[at(crossing)]);
      addChain([&](auto visit) {
        parts_.visitCorners(stretch, [&](RegionSideIndex side) {
          const Vector next = seen(parts_.pointOf(parts_.sideAfter(side)));
          visit(last, next);
          last = next;
        });
        visit(last, seen(all[at(stretch.to)]));
      });
    }
    for (const auto& one : parts_.ringsIn(cell_)) {
      addChain([&, ring = one.index](auto visit) {
        const std::int32_t begin = parts_.region.ringOffsets()[at(ring)];
        const std::int32_t end = parts_.region.ringOffsets()[at(ring) + 1];
        for (std::int32_t k = begin; k < end; ++k) {
          visit(seen(parts_.pointOf(k)), seen(parts_.pointOf(k + 1 == end ? begin : k + 1)));
        }
      });
    }
  }

  /// Adds triangles of which there may be very many.
  template <class VisitAll>
  void addChain(VisitAll visitAll) {
    CompensatedSum area;
    CompensatedSum x;
    CompensatedSum y;
    visitAll([&](Vector u, Vector v) {
      const double its = cross(u, v) / 2;
      area += its;
      x += its * (u.x + v.x) / 3;
      y += its * (u.y + v.y) / 3;
      boundary_ += lengthOf({v.x - u.x, v.y - u.y});
    });
    Moments& sum = moments_[row_];
    sum.area += area.value();
    sum.x += x.value();
    sum.y += y.value();
  }

  const ClipParts& parts_;
  const Diagram& diagram_;
  std::vector<Moments> moments_;
  std::vector<Point> references_;
  std::vector<Moments> overWhole_;  ///< by row of the edge in scope, of whole edges
  std::vector<Moments> overArc_;    ///< of Arcs::all()
  CompensatedSum boundary_;
  std::size_t row_ = 0;  ///< of the current cell
  CircleIndex cell_;
  std::vector<SideIndex> sides_;
};

}  // namespace

Point CellMoments::centroid(std::size_t row) const {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const auto& [area, x, y] = moments[row];
  if (!(area > 0)) return {kNaN, kNaN};
  return {references[row].x + x / area, references[row].y + y / area};
}

CellMoments momentsOf(const ClipParts& parts, const VisitArc& visit) { return Adder(parts, visit).run(); }

}  // namespace circle_voronoi
