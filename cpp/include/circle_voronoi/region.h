// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/box.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/index.h"
#include "circle_voronoi/limits.h"
#include "circle_voronoi/point.h"

namespace circle_voronoi {

struct RegionOptions {
  /// Whether polygons that share sides or overlap, as administrative areas do, become their union. A point belongs to a
  /// polygon if an odd number of its rings contain it, so rings may cross themselves, too. Rings without an area are
  /// left out. The union of polygons that share sides is exact; points where sides cross are rounded.
  ///
  /// Where sides nearly coincide, as those of copies that differ in their last digits, crossings that are rounded may
  /// cross again without end. If so, all points are rounded to a grid, mostly to 2^-51 (4.4e-16) of the largest
  /// coordinate, and sides are led through the points near them (snap rounding). No side moves by more than a step of
  /// the grid in x or y. If too many sides nearly coincide for that grid, its step is 2^6 times as large, up to 2^-33
  /// (1.2e-10) at most.
  ///
  /// Takes O((m + k) log^2 m) steps for m sides that meet in k places.
  bool dissolve = false;
};

/// A closed set in the plane: one or more polygons with holes. It is validated once, when it is made, and can be used
/// for many diagrams. Rings are counted through all polygons. Side k begins at point k of points().
///
/// A ring is a list of points. The last point may repeat the first one or not, points may repeat the point before them,
/// and the ring may run in either direction. The rules of the OGC's simple features apply, as GEOS and PostGIS check
/// them:
///
/// - A ring has at least three different points and does not cross or touch itself.
/// - Different rings do not cross and have no part of a side in common. They may touch in single points, unless that
///   cuts the interior of a polygon apart.
/// - The holes of a polygon lie in its outer ring, and neither holes nor polygons overlap.
///
/// All these tests are exact. Validation takes O(m log m) steps for m sides.
///
/// Numbers are at most 2^96 (7.9e28) in absolute value. Each is rounded once to a multiple of 2^-96 (1.3e-29), as every
/// number from 2^-44 (5.7e-14) up already is. If the largest number is not 0 and below 2^-56 (1.4e-17), there is an
/// error.
class CIRCLE_VORONOI_API Region {
 public:
  using Ring = std::vector<Point>;

  /// Makes a region from polygons. The first ring of a polygon is its outer ring, the others are its holes, as in
  /// GeoJSON.
  /// Errors: badOption if there is no polygon, a polygon has no ring, a coordinate is not finite, or a rule above is
  /// broken and `dissolve` is not set. The message names the rings, the sides and the point. coordinateTooLarge,
  /// coordinateTooSmall. tooManyCircles if there are more than kMaxRegionSides sides, the union of a region has more
  /// corners, or memory runs out. badArithmetic.
  static Result<Region> fromPolygons(std::span<const std::vector<Ring>> polygons, const RegionOptions& options = {});
  /// Makes a region from rings in any order: a point belongs to the region if an odd number of rings contain it. So a
  /// ring inside another one is a hole, and a ring inside that hole is an island. With `dissolve`, rings may cross and
  /// share sides, too, and the rule stays. Errors: see fromPolygons.
  static Result<Region> fromRings(std::span<const Ring> rings, const RegionOptions& options = {});
  /// Makes a region from flat arrays. Ring k consists of the points from ringOffsets[k] to before ringOffsets[k + 1].
  /// Polygon k consists of the rings from polygonOffsets[k] to before polygonOffsets[k + 1]. Without polygonOffsets the
  /// rings are interpreted like the rings of fromRings. Errors: see fromPolygons; badOption also if offsets decrease,
  /// do not begin with 0, or do not end with the number of points or rings.
  static Result<Region> fromArrays(std::span<const Point> points, std::span<const std::int32_t> ringOffsets,
                                   std::span<const std::int32_t> polygonOffsets = {},
                                   const RegionOptions& options = {});
  /// Makes a region from a box.
  /// Errors: badOption if the box is empty, or a coordinate is not finite or exceeds kRegionLimit; badArithmetic.
  static Result<Region> from(const Box& box);

  /// Returns the points of all rings without repetitions, one ring after the other. Outer rings run counter-clockwise
  /// and holes clockwise, so the region lies left of each side. The region must outlive the span.
  [[nodiscard]] std::span<const Point> points() const { return points_; }
  /// Returns where each ring begins in points(), and the number of points at the end.
  [[nodiscard]] std::span<const std::int32_t> ringOffsets() const { return ringOffsets_; }
  /// Returns where each polygon begins in the list of rings, and the number of rings at the end. The first ring of a
  /// polygon is its outer ring.
  [[nodiscard]] std::span<const std::int32_t> polygonOffsets() const { return polygonOffsets_; }

  [[nodiscard]] std::size_t sideCount() const { return points_.size(); }
  [[nodiscard]] std::size_t ringCount() const { return ringOffsets_.size() - 1; }
  [[nodiscard]] std::size_t polygonCount() const { return polygonOffsets_.size() - 1; }

  /// Returns the ring of a side. Takes O(log r) steps for r rings.
  [[nodiscard]] RegionRingIndex ringOf(RegionSideIndex side) const;
  /// Returns the polygon of a ring. Takes O(log p) steps for p polygons.
  [[nodiscard]] std::int32_t polygonOf(RegionRingIndex ring) const;

  /// Returns whether the region, boundary included, contains a point. The point is rounded first, as the corners were
  /// (limits.h); the result is exact. Skips runs of sides that lie on one side of the point, so it takes O(log m) steps
  /// for each run of sides of a ring that passes the point's right, a single one for most regions.
  [[nodiscard]] bool contains(Point p) const;
  /// Returns the sides whose bounding box meets a box, in increasing order. Takes O(log m) steps for each side found.
  [[nodiscard]] std::vector<RegionSideIndex> sidesIn(const Box& box) const;
  /// Returns sides in increasing order, among them each one that comes within `margin` of a convex polygon, which may
  /// be a segment or a point. Unlike `sidesIn`, skips slanted sides beside a slanted polygon. Takes O(log m) steps for
  /// each side found, if consecutive rings lie near each other.
  [[nodiscard]] std::vector<RegionSideIndex> sidesNear(std::span<const Point> polygon, double margin) const;
  /// Returns rings in increasing order: those whose first corner lies in none of the boxes for which a function returns
  /// true. The function gets a box around the first corners of consecutive rings, and the first of these rings.
  [[nodiscard]] std::vector<RegionRingIndex> ringsNotIn(
      const std::function<bool(const Box&, RegionRingIndex)>& isLeftOut) const;
  /// Returns the area, right to a few units of rounding.
  [[nodiscard]] double area() const;
  /// Returns the length of all sides.
  [[nodiscard]] double perimeter() const;
  /// Returns the bounding box.
  [[nodiscard]] Box bounds() const;

 private:
  friend Region scaledRegion(const Region& region, double factor);

  Region() = default;

  /// Returns the region of arrays without dissolving them. `limit` is the largest coordinate. Throws a ThrownError.
  static Region valid(std::span<const Point> points, std::span<const std::int32_t> ringOffsets,
                      std::span<const std::int32_t> polygonOffsets, double limit = kCoordinateLimit);

  /// A run of consecutive sides: its bounding box, and its extent along its longest side and across.
  struct Run {
    Box box;
    Vector along;  ///< the longest side
    double leastAlong, mostAlong;
    double leastAcross, mostAcross;
  };
  class Polygon;
  void index();
  void orderRuns(std::size_t begin, std::size_t end);
  [[nodiscard]] std::vector<Run> runsOf(std::size_t size) const;
  bool isInRun(std::size_t level, std::size_t run, Point p, bool& isOnBoundary) const;
  template <class MeetsRun, class MeetsSide>
  void addSides(std::size_t level, std::size_t group, const MeetsRun& meetsRun, const MeetsSide& meetsSide,
                std::vector<RegionSideIndex>& sides) const;
  template <class MeetsRun, class MeetsSide>
  std::vector<RegionSideIndex> sidesThat(const MeetsRun& meetsRun, const MeetsSide& meetsSide) const;

  std::vector<Point> points_;
  std::vector<std::int32_t> ringOffsets_;
  std::vector<std::int32_t> polygonOffsets_;
  std::vector<std::vector<Run>> runs_;     ///< by level: runs of a few sides first, one run of all sides last
  std::vector<std::int32_t> runsByPlace_;  ///< the runs of the first level, those that lie near each other together
  std::vector<std::vector<Run>> groups_;   ///< by level: groups of a few of these first, one group of all last
  /// Boxes around the first corners of rings, by level: those of a few rings first, one of all rings last.
  std::vector<std::vector<Box>> ringBoxes_;
};

}  // namespace circle_voronoi
