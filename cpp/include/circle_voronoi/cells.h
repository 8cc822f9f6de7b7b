// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/convex_polygon.h"
#include "circle_voronoi/curve.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/metric.h"
#include "circle_voronoi/point.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// The cells of a diagram: which sides each has, in order. Made once, in linear time but for sorting the hull.
///
/// An edge seen from one of its two cells is a *side* of that cell. Side 2 e of edge e belongs to the left circle and
/// runs from start to end; side 2 e + 1 belongs to the right circle and runs back. So every side has its own cell on
/// its left, and the sides of a cell run counter-clockwise around it.
///
/// The circles and the diagram must outlive this, so that it cannot be made of what is about to go; and the diagram
/// must be certified, or made by comparison.h with the same metric.
class Cells {
 public:
  Cells(std::span<const Circle> circles, const Diagram& diagram, Metric metric = Metric::circles);
  Cells(std::span<const Circle> circles, const Diagram&& diagram, Metric metric = Metric::circles) = delete;
  template <class Circles, class AnyDiagram>
  requires std::same_as<std::remove_const_t<Circles>, std::vector<Circle>> Cells(Circles&& circles,
                                                                                 AnyDiagram&& diagram,
                                                                                 Metric metric = Metric::circles)
  = delete;

  std::span<const Circle> circles() const { return circles_; }
  const Diagram& diagram() const { return *diagram_; }
  Metric metric() const { return metric_; }

  /// Hidden circles have no cell.
  bool exists(std::int32_t circle) const { return exists_[index(circle)] != 0; }

  /// The sides of a cell, counter-clockwise; none if there is no cell, or it is the whole plane. Where the cell goes to
  /// infinity, the next side after one that ends there begins there.
  std::span<const std::int32_t> sides(std::int32_t circle) const {
    return std::span(sides_).subspan(first_[index(circle)], first_[index(circle) + 1] - first_[index(circle)]);
  }

  std::int32_t circleOf(std::int32_t side) const { return side % 2 == 0 ? edge(side).left : edge(side).right; }
  /// The circle on the other side of the edge.
  std::int32_t neighborOf(std::int32_t side) const { return circleOf(side ^ 1); }
  /// The vertex where a side begins, or kNone.
  std::int32_t originOf(std::int32_t side) const { return side % 2 == 0 ? edge(side).start : edge(side).end; }
  /// The vertex where a side ends, or kNone.
  std::int32_t targetOf(std::int32_t side) const { return originOf(side ^ 1); }
  /// The curve of a side, with its cell on the left.
  EdgeCurve curveOf(std::int32_t side) const;

  /// The circles across the sides of a cell, in their order: a circle recurs if the two share several edges.
  std::vector<std::int32_t> neighbors(std::int32_t circle) const;

  double distance(std::int32_t circle, Point p) const {
    return circle_voronoi::distance(metric_, circles_[index(circle)], p);
  }

  /// How much nearer p is to one circle than to another, negative if the other is nearer: the difference of their
  /// distances, but without cancellation where p is far away. Of the power metric it is divided by a length.
  double lead(std::int32_t circle, std::int32_t other, Point p) const;

  /// Whether no circle is nearer to p, up to rounding. It suffices to ask the neighbours: a ray from the centre that
  /// leaves the cell across a side stays nearer to the neighbour there, and for the power metric a cell is the
  /// intersection of half-planes, one for each neighbour. False for a hidden circle.
  bool contains(std::int32_t circle, Point p) const;

 private:
  static std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }
  const Edge& edge(std::int32_t side) const { return diagram_->edges[index(side) / 2]; }
  std::vector<std::int32_t> nextSides() const;

  std::span<const Circle> circles_;
  const Diagram* diagram_;
  Metric metric_;
  std::vector<std::uint8_t> exists_;
  /// The sides of cell i are those from first_[i] to first_[i + 1] in sides_.
  std::vector<std::size_t> first_;
  std::vector<std::int32_t> sides_;
};

/// A piece of the outline of a clipped cell, with the cell on its left.
struct OutlinePiece {
  EdgeCurve curve;                ///< bounded
  std::int32_t side = kNone;      ///< of the cell; kNone: a piece of the boundary of the region
  std::int32_t neighbor = kNone;  ///< the circle on the other side; kNone likewise
};

/// Closed loops of pieces, counter-clockwise, one for each component: the end of a piece is the start of the next.
/// Pieces of length zero occur.
using Outline = std::vector<std::vector<OutlinePiece>>;

/// The part of a cell inside a region: empty if they do not meet, several loops if the region cuts the cell apart.
Outline outline(const Cells& cells, std::int32_t circle, const ConvexPolygon& region);

/// Exact up to rounding: polygons, and closed forms for what lies between an arc and its chord, by square roots alone.
double area(const Outline& outline);
/// The centre of mass, likewise. Of an outline without area but for rounding it is that of its end points; (0, 0) if it
/// is empty.
Point centroid(const Outline& outline);
/// The length of all pieces, likewise (arcLength).
double perimeter(const Outline& outline);

}  // namespace circle_voronoi
