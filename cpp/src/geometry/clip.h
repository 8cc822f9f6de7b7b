// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "circle_voronoi/convex_polygon.h"
#include "circle_voronoi/curve.h"
#include "circle_voronoi/index.h"
#include "vectors.h"

namespace circle_voronoi {

/// In place of a side of a polygon: the circle that cuts a cell at the maximum distance.
inline constexpr std::int32_t kCircleCut = -2;
/// In place of a side of a polygon: nothing. The end of the curve is at infinity, which here is a point far outside.
inline constexpr std::int32_t kFarCut = -3;

/// A part of a curve inside a region. `cutFrom` and `cutTo` are the sides of the region, or kCircleCut, on which the
/// ends of the part lie; kNone if the part ends where the curve does.
struct CurvePart {
  EdgeCurve curve;
  std::int32_t cutFrom = kNone;
  std::int32_t cutTo = kNone;

  /// Returns whether cutting has left a point.
  bool isPoint() const { return curve.start == curve.end && (cutFrom != kNone || cutTo != kNone); }
};

/// The half-plane left of a side of a polygon. Sides on one line make one half-plane.
class HalfPlane {
 public:
  HalfPlane(std::size_t side, Point from, Point to);

  /// The first side of the polygon on the line.
  std::int32_t side() const { return side_; }
  Point from() const { return from_; }
  Point to() const { return to_; }
  Vector along() const { return along_; }

  /// Returns how far a point is to the left of the line, in a unit of its own: negative outside. Exact for points
  /// on a line parallel to an axis.
  double height(Point p) const { return cross(along_, {p.x - from_.x, p.y - from_.y}); }
  /// Returns how far ahead along the line a point is, in the same unit.
  double place(Point p) const { return dot(along_, {p.x - from_.x, p.y - from_.y}); }
  /// Returns the point of the line nearest to p.
  Point nearest(Point p) const;
  /// Returns a point of the line, moved onto the side.
  Point onSide(Point p) const;

 private:
  std::int32_t side_;
  Point from_;
  Point to_;
  Vector along_;
};

std::vector<HalfPlane> halfPlanesOf(const ConvexPolygon& region);

/// Returns how far a point of a region may be from p, along one axis.
double reachFrom(Point p, const ConvexPolygon& region);

/// Returns a curve with its ends at infinity moved to points far outside a region, where clipping cuts them off.
CurvePart boundedPart(const EdgeCurve& curve, const ConvexPolygon& region);

/// Cuts a bounded part of a curve. Returns how many parts lie in the half-plane. They are in order.
std::size_t cutPart(const CurvePart& part, const HalfPlane& half, std::array<CurvePart, 2>& kept);

/// Moves the ends of a part that were cut off onto the sides that cut them. Rounding may have left them beyond a
/// corner.
void moveOntoSides(CurvePart& part, std::span<const HalfPlane> halves);

/// Returns the parts of a part of a curve inside a region, in order.
std::vector<CurvePart> partsInside(const CurvePart& part, const ConvexPolygon& region);

/// Returns the part of a curve within a distance of the origin of its bisector, the center of the smaller circle. It is
/// bounded. Returns nothing if there is none.
std::optional<CurvePart> partNear(const EdgeCurve& curve, double reach);

/// The crossings of a branch and the line through a point in a direction.
class LineCrossing {
 public:
  LineCrossing(const Bisector& bisector, Point p, Vector direction);

  /// Returns the parameters in increasing order: none, one or two.
  std::span<const double> parameters() const& { return {parameters_.data(), count_}; }
  std::span<const double> parameters() const&& = delete;

  /// Returns whether the branch goes from the left of the line to its right at a crossing, which is counted from 0.
  bool goesRight(std::size_t crossing) const { return goesRight_[crossing]; }

  /// Returns where the branch is farthest to the right of the line, or to its left, between two crossings. Returns
  /// nothing if there are no two, or the branch is on the other side between them.
  std::optional<double> turningPoint(bool right) const;

 private:
  double growth_;
  double half_;
  double decay_;
  std::size_t count_ = 0;
  std::array<double, 2> parameters_ = {};
  std::array<bool, 2> goesRight_ = {};
};

}  // namespace circle_voronoi
