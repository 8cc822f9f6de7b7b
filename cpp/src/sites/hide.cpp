// SPDX-License-Identifier: GPL-3.0-or-later
#include "hide.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "at.h"
#include "centers.h"
#include "infinity.h"
#include "vectors.h"

namespace circle_voronoi {
namespace {

/// Returns whether the larger of two circles, its radius reduced by `smallest`, may contain the center of the other.
bool mayReach(const Circle& a, const Circle& b, double smallest) {
  return !isLonger(between(a, b), std::max(a.r, b.r) - smallest);
}

/// Returns whether no circle, its radius reduced by `smallest`, contains the center of a neighbor in the Delaunay
/// graph. Then none hides another, because the centers that a disc around a center contains are connected in this
/// graph. Precondition: no two centers are equal.
bool areClear(std::span<const Circle> circles, double smallest, const Dual& dual, Threads threads) {
  // Tests most edges twice. This costs less than finding out which half of an edge comes first.
  const auto isReached = [&](std::size_t h) {
    const int i = dual.origin[h];
    const int j = dual.target(static_cast<int>(h));
    return i != kPointAtInfinity && j != kPointAtInfinity && mayReach(circles[at(i)], circles[at(j)], smallest);
  };
  return threads.firstWhere(dual.origin.size(), isReached) == dual.origin.size();
}

/// Returns whether successive circles pass the same test. It is quick, and they rarely pass if circles hide one
/// another. Circles with the same center follow one another, and do not pass.
bool lookClear(std::span<const Circle> circles, double smallest) {
  for (std::size_t i = 1; i < circles.size(); ++i) {
    if (mayReach(circles[i - 1], circles[i], smallest)) return false;
  }
  return true;
}

/// The triangulation of the centers, if it was computed.
struct Centers {
  std::optional<Delaunay> delaunay;
  bool areClear = false;  ///< whether it shows that no circle hides another
};

/// Triangulates the centers if circles look clear.
Centers centersIfClear(std::span<const Circle> circles, Threads threads) {
  double smallest = kInfinite;
  for (const Circle& c : circles) smallest = std::min(smallest, c.r);
  if (!lookClear(circles, smallest)) return {};
  Delaunay centers = delaunay(centersOf(circles), threads);
  const bool isClear = areClear(circles, smallest, centers.dual, threads);
  return {std::move(centers), isClear};
}

}  // namespace

Sites withoutHidden(const OrderedCircles& ordered, const Hiders& found) {
  const auto& [circles, indices] = ordered;
  const auto& hider = found.hider;
  Sites visible;
  visible.steps = found.steps;
  visible.circles.reserve(circles.size());
  visible.indices.reserve(circles.size());
  for (std::size_t i = 0; i < circles.size(); ++i) {
    if (hider[i] == kNone) {
      visible.circles.push_back(circles[i]);
      visible.indices.push_back(indices[i]);
    } else {
      visible.hidden.push_back({indices[i], indices[at(hider[i])]});
    }
  }
  std::sort(visible.hidden.begin(), visible.hidden.end(),
            [](const HiddenCircle& a, const HiddenCircle& b) { return a.circle < b.circle; });
  return visible;
}

std::optional<Sites> hide(OrderedCircles& ordered, std::int64_t mostSteps, Threads threads) {
  Centers centers = centersIfClear(ordered.circles, threads);
  if (centers.areClear) {
    Sites sites;
    sites.circles = std::move(ordered.circles);
    sites.indices = std::move(ordered.indices);
    sites.centers = std::move(centers.delaunay->dual);
    return sites;
  }
  const NumberedCircles all{ordered.circles, ordered.indices};
  const Hiders found = findHiders(all, all, mostSteps, threads);
  if (found.hider.empty()) return std::nullopt;
  Sites sites = withoutHidden(ordered, found);
  // Some circles are near one another, but none is hidden.
  if (centers.delaunay && sites.hidden.empty()) sites.centers = std::move(centers.delaunay->dual);
  return sites;
}

}  // namespace circle_voronoi
