// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "arcs.h"
#include "cell_moments.h"
#include "circle_voronoi/clipped_diagram.h"
#include "crossings.h"
#include "side_after.h"

namespace circle_voronoi {

/// A piece of a loop, up to the start of the next piece.
struct LoopPiece {
  Point start;
  SideIndex side = {};              ///< the side of the cell, or kNone
  RegionSideIndex regionSide = {};  ///< the side of the region, or kNone
  std::int32_t arc = kNone;         ///< the arc of the side in Arcs::all(); kNone for a whole edge
};

/// Loops of pieces. A hole comes after the loop around it.
struct Loops {
  std::vector<LoopPiece> pieces;
  std::vector<std::int32_t> offsets = {0};  ///< for each loop where its pieces begin, and their number
  std::vector<std::uint8_t> isHole;

  std::span<const LoopPiece> loop(std::size_t k) const {
    return std::span(pieces).subspan(static_cast<std::size_t>(offsets[k]),
                                     static_cast<std::size_t>(offsets[k + 1] - offsets[k]));
  }
  void clear() {
    pieces.clear();
    offsets.assign(1, 0);
    isHole.clear();
  }
};

/// The data of a ClippedDiagram. Exported because fits and the library for files use them.
class CIRCLE_VORONOI_API ClipParts {
 public:
  static const ClipParts& of(const ClippedDiagram& clipped) { return *clipped.parts_; }

  /// Clips all cells, or some, and calls `visit` with each part of an edge inside the region, so that its curve is
  /// computed once. Errors: see ClippedDiagram.
  static Result<ClippedDiagram> clip(const Diagram& diagram, const Region& region, std::optional<double> maxDistance,
                                     std::optional<std::span<const CircleIndex>> circles, const VisitArc& visit);

  /// For all cells, or for some. Throws a ThrownError if the judge finds a fault (judge_clip.h).
  ClipParts(const Diagram& diagram, const Region& region, std::optional<double> maxDistance,
            std::optional<std::span<const CircleIndex>> circles, const VisitArc& visit);

  using Place = ClippedDiagram::Place;
  /// Returns how a cell lies to the region, whatever the maximum distance. A cell that is not clipped counts as
  /// outside.
  Place placeOf(CircleIndex circle) const {
    const std::int32_t row = scope.cells.rowOf(circle);
    return row == kNone ? Place::outside : places_[static_cast<std::size_t>(row)];
  }

  /// Returns whether an edge without crossings lies in the region.
  bool isInside(EdgeIndex edge) const { return arcs.isInside(diagram.edges[static_cast<std::size_t>(edge)].start); }

  /// The loops of a cell in the region, whatever the maximum distance.
  void loopsOf(CircleIndex circle, Loops& loops) const;

  /// The curve of a whole edge, and that of an arc, in the direction of the edge.
  EdgeCurve curveOf(EdgeIndex edge) const { return edgeCurve(diagram, edge); }
  EdgeCurve curveOf(const Arc& arc) const;
  /// The curve of an arc in the direction of orderedCurve.
  EdgeCurve orderedCurveOf(const Arc& arc) const;
  /// The curve of a piece that is a side, in the direction of its loop.
  EdgeCurve curveOf(const LoopPiece& piece) const;

  std::vector<OutlinePiece> piecesOf(std::span<const LoopPiece> loop) const;
  /// Returns a point of a cell from which all of it is seen, given some of its loops, which are not empty.
  Point middleOf(CircleIndex circle, const Outline& loops) const;

  /// A stretch of the boundary in one cell: from a crossing to the next one of its ring.
  struct Stretch {
    std::int32_t from;
    std::int32_t to;
  };
  Stretch stretchFrom(std::int32_t crossing) const {
    return {crossing, crossings.next[static_cast<std::size_t>(crossing)]};
  }
  /// The cell in which the boundary goes on from a crossing.
  CircleIndex cellAfter(const Crossing& crossing) const {
    const Edge& edge = diagram.edges[static_cast<std::size_t>(crossing.edge)];
    return crossing.isEntry ? edge.right : edge.left;
  }
  /// Calls `visit(side)` with the sides of the region whose ends lie on a stretch, in order.
  template <class Visit>
  void visitCorners(const Stretch& stretch, Visit visit) const;

  struct InCell {
    CircleIndex cell;
    std::int32_t index;
  };
  /// The crossings after which the boundary goes on in a cell, along the sides of the region, and the rings that lie in
  /// the cell. Their order depends on the cell, its neighbors and the region alone.
  std::span<const InCell> crossingsInto(CircleIndex cell) const { return within(into_, cell); }
  std::span<const InCell> ringsIn(CircleIndex cell) const { return within(rings_, cell); }
  std::span<const InCell> allCrossings() const { return into_; }
  std::span<const InCell> allRings() const { return rings_; }

  Point pointOf(RegionSideIndex side) const { return region.points()[static_cast<std::size_t>(side)]; }
  RegionSideIndex sideAfter(RegionSideIndex side) const { return circle_voronoi::sideAfter(region, side); }

  const Diagram& diagram;
  const Region& region;
  const std::optional<double> maxDistance;
  const Box bounds;
  const ClipScope scope;
  const Crossings crossings;
  const Arcs arcs;
  CellMoments moments;

 private:
  static std::span<const InCell> within(const std::vector<InCell>& all, CircleIndex cell);
  void addChain(std::int32_t first, std::vector<std::uint8_t>& isDone, Loops& loops) const;
  std::int32_t addArcs(std::int32_t crossing, Loops& loops) const;
  bool isBorderInside(CircleIndex circle) const;
  std::vector<std::vector<std::int32_t>> holesIn(CircleIndex circle, const Loops& loops,
                                                 const std::vector<std::int32_t>& polygons,
                                                 const std::vector<std::int32_t>& holes) const;
  void judgePartsWithin() const;

  std::vector<InCell> into_;
  std::vector<std::int32_t> placesInto_;  ///< for each crossing its place in into_, or kNone
  std::vector<InCell> rings_;
  std::vector<Place> places_;  ///< by row of the cell in scope
};

/// Adds up the moments of the parts of the cells in the region, whatever the maximum distance.
CellMoments momentsOf(const ClipParts& parts, const VisitArc& visit);

template <class Visit>
void ClipParts::visitCorners(const Stretch& stretch, Visit visit) const {
  if (crossings.isOnSideOfNext[static_cast<std::size_t>(stretch.from)] != 0) return;
  RegionSideIndex side = crossings.all[static_cast<std::size_t>(stretch.from)].side;
  const RegionSideIndex last = crossings.all[static_cast<std::size_t>(stretch.to)].side;
  const RegionRingIndex ring = region.ringOf(side);
  do {
    visit(side);
    side = circle_voronoi::sideAfter(region, side, ring);
  } while (side != last);
}

}  // namespace circle_voronoi
