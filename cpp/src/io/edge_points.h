// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "export_frame.h"
#include "portable.h"
#include "prefetch.h"

namespace circle_voronoi {

/// The points of the edges inside the box of an export. Each such edge is followed once, and its points serve both
/// cells and the edge itself.
struct EdgePoints {
  /// Takes a point for each vertex. For each edge inside the box, `follow(edge, curve, *this)` appends the points
  /// between its ends to `inner`.
  template <class Follow>
  EdgePoints(const ExportFrame& its, std::vector<Point> pointsOfVertices, Follow follow)
      : frame(its), diagram(its.diagram), places(std::move(pointsOfVertices)) {
    isInside.reserve(diagram.edges.size());
    firstInner.reserve(diagram.edges.size() + 1);
    for (std::size_t e = 0; e < diagram.edges.size(); ++e) {
      const EdgeCurve curve = edgeCurve(diagram, static_cast<std::int32_t>(e));
      isInside.push_back(circle_voronoi::isInside(frame, diagram.edges[e], curve));
      firstInner.push_back(inner.size());
      if (isInside.back()) follow(diagram.edges[e], curve, *this);
    }
    firstInner.push_back(inner.size());
  }

  Point placeOf(VertexIndex vertex) const { return places[static_cast<std::size_t>(vertex)]; }
  bool hasInside(EdgeIndex edge) const { return isInside[static_cast<std::size_t>(edge)]; }

  /// Returns whether the circle has a cell with all edges inside the box.
  bool isWhole(CircleIndex circle) const {
    const auto sides = diagram.sides(circle);
    const auto hasEdge = [&](SideIndex side) { return hasInside(Diagram::edgeOf(side)); };
    return !sides.empty() && std::ranges::all_of(sides, hasEdge);
  }

  /// Returns the points between the ends of an edge.
  std::span<const Point> innerOf(EdgeIndex edge) const {
    const auto e = static_cast<std::size_t>(edge);
    return std::span(inner).subspan(firstInner[e], firstInner[e + 1] - firstInner[e]);
  }

  /// Calls `visit(first, last)` with iterators over the points between the ends of a side, in its direction.
  template <class Visit>
  void visitInner(SideIndex side, Visit visit) const {
    const auto points = innerOf(Diagram::edgeOf(side));
    if (side % 2 == 0) {
      visit(points.begin(), points.end());
    } else {
      visit(points.rbegin(), points.rend());
    }
  }

  /// Calls `visitCell` with each circle in order. The memory of its edges is requested ahead, so that the visit does
  /// not wait for it.
  template <class VisitCell>
  void visitCells(VisitCell visitCell) const {
    const auto count = static_cast<std::int32_t>(diagram.circles.size());
    constexpr std::int32_t kAhead = 3;
    for (std::int32_t i = 0; i < count; ++i) {
      if (count - i > 2 * kAhead) prefetchEdges(i + 2 * kAhead);
      if (count - i > kAhead) prefetchPoints(i + kAhead);
      visitCell(i);
    }
  }

  // Inlined, because a compiler may drop calls of a function that only prefetches.
  CIRCLE_VORONOI_ALWAYS_INLINE void prefetchEdges(CircleIndex circle) const {
    for (const SideIndex side : diagram.sides(circle)) {
      prefetch(diagram.edges, static_cast<std::size_t>(side / 2));
      prefetch(firstInner, static_cast<std::size_t>(side / 2));
    }
  }
  CIRCLE_VORONOI_ALWAYS_INLINE void prefetchPoints(CircleIndex circle) const {
    for (const SideIndex side : diagram.sides(circle)) {
      prefetch(inner, firstInner[static_cast<std::size_t>(side / 2)]);
      const VertexIndex vertex = diagram.originOf(side);
      if (vertex == kNone) continue;
      prefetch(places, static_cast<std::size_t>(vertex));
      prefetch(diagram.vertices, static_cast<std::size_t>(vertex));
    }
  }

  const ExportFrame& frame;
  const Diagram& diagram;
  std::vector<Point> places;   ///< of each vertex
  std::vector<bool> isInside;  ///< of each edge
  /// For each edge where its points between its ends begin in `inner`, and the number of all at the end.
  std::vector<std::size_t> firstInner;
  std::vector<Point> inner;
};

}  // namespace circle_voronoi
