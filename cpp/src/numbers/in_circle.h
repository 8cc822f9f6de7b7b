// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "estimate.h"
#include "vectors.h"

namespace circle_voronoi {

/// Exact tests of points, fast for the coordinates that people draw: integers and short decimals, whose ties no
/// floating-point filter decides.
///
/// Laws (laws_test.cpp):
///   orientation(a, b, c) == orientation(b, c, a) == -orientation(b, a, c).
///   inCircle(a, b, c, d) == inCircle(b, c, a, d) == inCircle(b, a, d, c).

/// Returns 1 if points a, b, c are counter-clockwise, -1 if they are clockwise, 0 if they are collinear. Coordinates
/// are at most kRegionLimit. The sign is exact if they are rounded (rounded.h); otherwise it may be 0 for points that
/// are collinear once rounded.
int orientation(Point a, Point b, Point c);

/// Returns 1 if point d lies inside the circle through a, b, c, which are counter-clockwise; 0 if it lies on the
/// circle; -1 if it lies outside. Coordinates are rounded.
int inCircle(Point a, Point b, Point c, Point d);

// Error bounds of the floating-point determinants, relative to their permanents: J. R. Shewchuk, "Adaptive precision
// floating-point arithmetic and fast robust geometric predicates", 1997, section 4.
inline constexpr double kOrientationError = (3 + 16 * kUnitRoundoff) * kUnitRoundoff;
inline constexpr double kInCircleError = (10 + 96 * kUnitRoundoff) * kUnitRoundoff;

inline Estimate orientationOf(Point a, Point b, Point c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  return {left - right, kOrientationError * (std::abs(left) + std::abs(right)) + kUnderflowError};
}

/// The in-circle determinant with two error bounds. The second is smaller and takes longer to compute.
class InCircleEstimate {
 public:
  InCircleEstimate(Point a, Point b, Point c, Point d)
      : ax_(a.x - d.x), ay_(a.y - d.y), bx_(b.x - d.x), by_(b.y - d.y), cx_(c.x - d.x), cy_(c.y - d.y) {}

  /// Returns the determinant with a coarse bound. Shewchuk's bound is in aa (|bx cy| + |by cx|) + ..., which is at most
  /// aa sqrt(bb cc) + ... and so at most aa bb + bb cc + cc aa <= (aa + bb + cc)^2 / 3. This is rarely too coarse for
  /// points near one another.
  Estimate coarse() const {
    const double size = aa_ + bb_ + cc_;
    return {value_, 0.34 * kInCircleError * size * size + kUnderflowError};
  }
  Estimate fine() const {
    const double permanent = aa_ * (std::abs(bx_ * cy_) + std::abs(by_ * cx_)) +
                             bb_ * (std::abs(cx_ * ay_) + std::abs(cy_ * ax_)) +
                             cc_ * (std::abs(ax_ * by_) + std::abs(ay_ * bx_));
    return {value_, kInCircleError * permanent + kUnderflowError};
  }

 private:
  double ax_, ay_, bx_, by_, cx_, cy_;
  double aa_ = ax_ * ax_ + ay_ * ay_;
  double bb_ = bx_ * bx_ + by_ * by_;
  double cc_ = cx_ * cx_ + cy_ * cy_;
  double value_ = aa_ * (bx_ * cy_ - by_ * cx_) + bb_ * (cx_ * ay_ - cy_ * ax_) + cc_ * (ax_ * by_ - ay_ * bx_);
};

}  // namespace circle_voronoi
