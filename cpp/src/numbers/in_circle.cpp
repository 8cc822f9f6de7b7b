// SPDX-License-Identifier: GPL-3.0-or-later
#include "in_circle.h"

#include <algorithm>
#include <cmath>

#include "exact.h"
#include "rounded.h"
#include "short_differences.h"

namespace circle_voronoi {
namespace {

int signOf(double value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

/// Returns a point as exact integers hold it: rounded, and inside the range of boxes. Computed points need not be
/// rounded. Beyond the range there are only points of diagrams whose arrays a program has changed; NaN may be anywhere.
Point held(Point p) {
  const auto within = [](double x) { return x >= -kRegionLimit ? std::min(x, kRegionLimit) : -kRegionLimit; };
  return rounded(Point{within(p.x), within(p.y)});
}

}  // namespace

int orientation(Point a, Point b, Point c) {
  const Estimate estimate = orientationOf(a, b, c);
  if (const int sign = estimate.sign(); sign != 0) return sign;
  // Both products are exactly zero, as on a line along an axis.
  if ((a.x == c.x || b.y == c.y) && (a.y == c.y || b.x == c.x)) return 0;
  const double largest =
      std::max(std::max(std::abs(a.x - c.x), std::abs(a.y - c.y)), std::max(std::abs(b.x - c.x), std::abs(b.y - c.y)));
  if (haveShortDifferences<26>({a, b, c}, largest)) return signOf(estimate.value);
  return exact::orientation(held(a), held(b), held(c));
}

int inCircle(Point a, Point b, Point c, Point d) {
  const double largest = std::max({std::abs(a.x - d.x), std::abs(a.y - d.y), std::abs(b.x - d.x), std::abs(b.y - d.y),
                                   std::abs(c.x - d.x), std::abs(c.y - d.y)});
  const InCircleEstimate estimate(a, b, c, d);
  if (const int sign = estimate.coarse().sign(); sign != 0) return sign;
  // The determinant is at most 12 times the fourth power of the largest difference.
  if (haveShortDifferences<12>({a, b, c, d}, largest)) return signOf(estimate.coarse().value);
  if (const int sign = estimate.fine().sign(); sign != 0) return sign;
  return exact::inCircle(a, b, c, d);
}

}  // namespace circle_voronoi
