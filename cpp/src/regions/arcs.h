// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "circle_voronoi/diagram.h"
#include "circle_voronoi/region.h"
#include "clip_scope.h"
#include "crossings.h"

namespace circle_voronoi {

/// A part of an edge in the region, in the direction of the edge.
struct Arc {
  EdgeIndex edge = {};
  std::int32_t start = kNone;  ///< the crossing where it begins; kNone for the vertex where the edge begins
  std::int32_t end = kNone;    ///< the crossing where it ends; kNone for the vertex where the edge ends
};

/// The parts of edges that lie in a region.
///
/// The *level* of a vertex is how often the boundary of the region winds around it: 1 in the region, 0 outside. Levels
/// follow from the crossings alone. At infinity the level is 0, and along an edge it goes up by 1 at each entry and
/// down by 1 at each exit. Because each ring is a closed path in the dual, all ways to a vertex lead to the same level.
///
/// Along an edge, entries and exits alternate in the order of crossings (crossing_order.h).
class Arcs {
 public:
  /// Finds the arcs of the edges of the scope, from the crossings of these edges.
  Arcs(const Diagram& diagram, const Region& region, const ClipScope& scope, const Crossings& crossings);

  bool isCrossed(EdgeIndex edge) const {
    return scope_.isAll() ? isCrossed_[static_cast<std::size_t>(edge)] : crossed_.has(edge);
  }
  /// Returns whether the region contains a vertex. It does not contain infinity (kNone), nor vertices out of scope.
  bool isInside(VertexIndex vertex) const {
    if (vertex == kNone) return false;
    const std::int32_t row = scope_.vertices.rowOf(vertex);
    return row != kNone && levels_[static_cast<std::size_t>(row)] == 1;
  }
  /// Returns the levels of the vertices in scope.
  std::span<const std::int32_t> levels() const { return levels_; }

  /// Returns all arcs of edges with crossings, edge by edge, in the direction of each edge.
  std::span<const Arc> all() const { return arcs_; }
  /// Returns the arcs of an edge with crossings.
  std::span<const Arc> of(EdgeIndex edge) const;
  /// Returns the arc that begins or ends at a crossing, by its place in all().
  std::int32_t arcAt(std::int32_t crossing) const { return arcOf_[static_cast<std::size_t>(crossing)]; }
  /// Returns the arc of an edge with crossings that begins (or ends) at the vertex there, which is inside.
  std::int32_t atVertex(EdgeIndex edge, bool isAtStart) const;

 private:
  void sortCrossings(const Region& region);
  std::int32_t riseAlong(EdgeIndex edge) const;
  std::int32_t levelBefore(SideIndex side) const;
  void findLevels();
  void findLevels(const Region& region);
  void makeArcs();

  const Diagram& diagram_;
  const ClipScope& scope_;
  const Crossings& crossings_;
  std::vector<bool> isCrossed_;           ///< if all cells are clipped: for each edge, in bits that stay in the cache
  Chosen crossed_;                        ///< the edges with crossings
  std::vector<std::int32_t> order_;       ///< the crossings by edge, and along it
  std::vector<std::int32_t> orderStart_;  ///< for each edge with crossings where they begin in order_
  std::vector<std::int32_t> levels_;
  std::vector<Arc> arcs_;
  std::vector<std::int32_t> arcStart_;  ///< for each edge with crossings where its arcs begin
  std::vector<std::int32_t> arcOf_;
};

}  // namespace circle_voronoi
