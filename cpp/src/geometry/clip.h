// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "circle_voronoi/curve.h"
#include "ring.h"

namespace circle_voronoi {

/// A part of a curve inside a region. `cutFrom` and `cutTo` are the sides of the region, or its circle (ring.h), on
/// which the ends of the part lie; kNone if the part ends where the curve does.
struct CurvePart {
  EdgeCurve curve;
  std::int32_t cutFrom = kNone;
  std::int32_t cutTo = kNone;
};

/// Returns the parts of a curve inside a region, in order. They are bounded.
std::vector<CurvePart> partsInside(const EdgeCurve& curve, const ConvexPolygon& region);

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

  /// Returns whether the branch lies right of the line between two parameters, which may be 0 and infinity.
  /// Precondition: it does not cross the line between them.
  bool isRight(double from, double to) const;

 private:
  double growth_;
  double half_;
  double decay_;
  std::size_t count_ = 0;
  std::array<double, 2> parameters_ = {};
  std::array<bool, 2> goesRight_ = {};
};

}  // namespace circle_voronoi
