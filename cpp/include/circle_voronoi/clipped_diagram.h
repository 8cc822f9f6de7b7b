// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/cells.h"
#include "circle_voronoi/curve.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/point.h"
#include "circle_voronoi/queries.h"
#include "circle_voronoi/region.h"

namespace circle_voronoi {

/// The parts of cells in a region, as flat arrays. Row k belongs to the k-th cell that was asked for.
///
/// Piece p runs from (x[p], y[p]) to the start of the next piece of its loop. One of its indices determines its kind:
/// `side` is not kNone on an arc of an edge, `regionSide` is not kNone on a side of the region, and `r` is positive on
/// an arc of a circle around the center of the cell (OutlinePiece).
struct ClippedCells {
  /// For each row where its loops begin, and the number of loops at the end.
  std::vector<std::int32_t> loopOffsets = {0};
  /// For each loop whether it is a hole of the last loop before it that is not. Holes run clockwise, other loops
  /// counter-clockwise.
  std::vector<std::uint8_t> isHole;
  /// For each loop where its pieces begin, and the number of pieces at the end.
  std::vector<std::int32_t> pieceOffsets = {0};

  std::vector<double> x;
  std::vector<double> y;
  std::vector<SideIndex> side;
  std::vector<RegionSideIndex> regionSide;
  std::vector<double> r;
};

/// The parts of edges in a region, as flat arrays, in increasing order of edges and along each edge in its direction.
struct ClippedEdges {
  std::vector<EdgeIndex> edge;
  /// The parameters of both ends on the bisector of edgeCurve(diagram, edge).
  std::vector<double> from;
  std::vector<double> to;
  std::vector<Point> start;
  std::vector<Point> end;
  /// The side of the region on which each end lies, or kNone if it is a vertex or is cut by the maximum distance.
  std::vector<RegionSideIndex> startSide;
  std::vector<RegionSideIndex> endSide;
};

/// Polygons with holes for cells in a region, as flat arrays. Rings are closed without repeating the first point. The
/// first ring of a polygon is its outer ring, counter-clockwise. Holes are clockwise.
struct ClippedPolygons {
  std::vector<std::int32_t> polygonOffsets = {0};  ///< for each row where its polygons begin, and their number
  std::vector<std::int32_t> ringOffsets = {0};     ///< for each polygon where its rings begin, and their number
  std::vector<std::int32_t> pointOffsets = {0};    ///< for each ring where its points begin, and their number
  std::vector<Point> points;
};

class ClipParts;

/// A diagram in a region: the parts of its cells and edges that lie inside.
///
/// The boundary of the region is followed through the diagram once, from cell to cell. This takes linear time in sides,
/// crossings and cells. Exact signs decide which edges it crosses, as if the region were moved by less than any number.
/// So a corner exactly at a vertex, or a side along an edge, is as good as any other. A judge checks each clip. All
/// cells on a crossing take the same point from it, to the bit, so that they fit together without gaps and overlaps.
class CIRCLE_VORONOI_API ClippedDiagram {
 public:
  /// Clips a certified diagram to a region. Cells are also cut at `maxDistance` from their circle, if that is given
  /// (outlineWithin). The diagram and the region must outlive the result.
  /// Errors: badInput if the arrays of the diagram do not fit together (checked in linear time, so that nothing outside
  /// them is read); badOption if `maxDistance` is not finite or exceeds kRegionLimit; notCertified if the judge finds a
  /// fault, as for a diagram that is not certified; tooManyCircles if memory runs out; internal.
  static Result<ClippedDiagram> from(const Diagram& diagram, const Region& region,
                                     std::optional<double> maxDistance = {});
  static Result<ClippedDiagram> from(const Diagram&& diagram, const Region& region,
                                     std::optional<double> maxDistance = {}) = delete;
  static Result<ClippedDiagram> from(const Diagram& diagram, const Region&& region,
                                     std::optional<double> maxDistance = {}) = delete;

  /// Clips some cells only, in time for these cells, their sides, and the sides of the region near them: O(log m) steps
  /// for each side found among m. A cell that the boundary does not cross also takes time for the sides that a ray to
  /// the right crosses. All other cells count as outside the region, and so do edges between them. The cells have the
  /// outlines and measures that `from` gives them, to the bit, and so they have in the diagram of these circles and
  /// their neighbors alone. After an edit, clip the cells whose sides have changed anew. A cell has the same polygon as
  /// after `from` only if its neighbors are clipped, too. Errors: see `from`; only the arrays of these cells are
  /// checked.
  static Result<ClippedDiagram> ofCells(const Diagram& diagram, const Region& region,
                                        std::span<const CircleIndex> circles, std::optional<double> maxDistance = {});
  static Result<ClippedDiagram> ofCells(const Diagram&& diagram, const Region& region,
                                        std::span<const CircleIndex> circles,
                                        std::optional<double> maxDistance = {}) = delete;
  static Result<ClippedDiagram> ofCells(const Diagram& diagram, const Region&& region,
                                        std::span<const CircleIndex> circles,
                                        std::optional<double> maxDistance = {}) = delete;

  [[nodiscard]] const Diagram& diagram() const;
  [[nodiscard]] const Region& region() const;
  [[nodiscard]] std::optional<double> maxDistance() const;

  /// How a cell lies to the region, and to the maximum distance.
  enum class Place : std::uint8_t {
    outside,  ///< the cell has no part in the region, or there is no cell
    inside,   ///< the whole cell is kept
    cut,      ///< a part of the cell may be kept
  };
  [[nodiscard]] Place placeOf(CircleIndex circle) const;

  /// Returns the outline of the kept part of a cell. Its holes are clockwise loops after the loop around them.
  [[nodiscard]] Outline outline(CircleIndex circle) const;
  /// Returns the outlines of all cells.
  [[nodiscard]] ClippedCells cells() const;
  /// Returns the outlines of some cells.
  [[nodiscard]] ClippedCells cells(std::span<const CircleIndex> circles) const;

  /// Returns the kept parts of an edge, in its direction.
  [[nodiscard]] std::vector<EdgeCurve> edgeParts(EdgeIndex edge) const;
  /// Returns the kept parts of all edges.
  [[nodiscard]] ClippedEdges edges() const;
  /// Returns the circles whose cells share a part of an edge with a cell inside the region, in the order of the sides
  /// of the cell. Each occurs once.
  [[nodiscard]] std::vector<CircleIndex> neighbors(CircleIndex circle) const;

  /// Returns the area of the kept part of a cell.
  [[nodiscard]] double area(CircleIndex circle) const;
  /// Returns the center of mass of the kept part of a cell; NaN if there is none.
  [[nodiscard]] Point centroid(CircleIndex circle) const;
  /// Returns the length of the outline of a cell, holes included.
  [[nodiscard]] double perimeter(CircleIndex circle) const;

  /// Returns the areas of the kept parts of all cells. They sum to the area of the region but for rounding, if there is
  /// no maximum distance.
  [[nodiscard]] std::vector<double> areas() const;
  /// Returns the centers of mass of the kept parts of all cells; NaN for a cell without one.
  [[nodiscard]] std::vector<Point> centroids() const;
  /// Returns the lengths of the outlines of all cells, holes included.
  [[nodiscard]] std::vector<double> perimeters() const;

  /// Returns polygons that stay within `tolerance` of the kept parts of all cells. Neighbors share their points to the
  /// bit. A row has several polygons if the region cuts the cell apart. The tolerance is finite and positive.
  [[nodiscard]] ClippedPolygons polygons(double tolerance) const;

  /// Returns the largest disc that has its center in the region and overlaps no circle: the point of the region
  /// farthest from all circles. It may extend beyond the region. Its radius is negative if circles cover the region.
  /// Returns nothing if there are no circles. The maximum distance plays no role.
  ///
  /// The distance from the nearest circle is largest at a vertex, at a crossing of an edge and the boundary, or at a
  /// corner, because inside a cell it is convex along every line.
  [[nodiscard]] std::optional<EmptyDisc> largestEmptyDisc() const;

 private:
  friend class ClipParts;
  explicit ClippedDiagram(std::shared_ptr<const ClipParts> parts) : parts_(std::move(parts)) {}

  std::shared_ptr<const ClipParts> parts_;
};

}  // namespace circle_voronoi
