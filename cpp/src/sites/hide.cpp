// SPDX-License-Identifier: GPL-3.0-or-later
#include "hide.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "centres.h"
#include "hiders.h"
#include "vectors.h"

namespace circle_voronoi {
namespace {

/// Whether the larger of two circles, its radius taken less the smallest one, may contain the centre of the other.
bool mayReach(const Circle& a, const Circle& b, double smallest) {
  const Vector v = between(a, b);
  const double reach = std::max(a.r, b.r) - smallest;
  return dot(v, v) <= reach * reach * (1 + 1e-12);
}

/// Whether no circle contains the centre of a neighbour in the Delaunay graph, its radius taken less the smallest one.
/// Then none hides another, for the centres that a disc around a centre contains are connected in that graph.
bool areClear(std::span<const Circle> circles, double smallest, const Delaunay& centres) {
  for (std::size_t i = 0; i < circles.size(); ++i) {
    if (centres.representative[i] != static_cast<int>(i)) return false;
  }
  const Dual& dual = centres.dual;
  // Most edges twice, which costs less than to tell which half of an edge comes first.
  for (int h = 0; h < dual.halfEdgeCount(); ++h) {
    const int i = dual.origin[h];
    const int j = dual.target(h);
    if (i != kInfinity && j != kInfinity && mayReach(circles[i], circles[j], smallest)) return false;
  }
  return true;
}

/// The same test on successive circles alone: quick, and rarely passed where circles hide one another.
bool lookClear(std::span<const Circle> circles, double smallest) {
  for (std::size_t i = 1; i < circles.size(); ++i) {
    if (mayReach(circles[i - 1], circles[i], smallest)) return false;
  }
  return true;
}

/// The triangulation of the centres, if it shows that no circle hides another.
std::optional<Dual> proofOfClearance(std::span<const Circle> circles) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Circle& c : circles) smallest = std::min(smallest, c.r);
  if (!lookClear(circles, smallest)) return std::nullopt;
  Delaunay centres = delaunay(centresOf(circles));
  if (!areClear(circles, smallest, centres)) return std::nullopt;
  return std::move(centres.dual);
}

}  // namespace

VisibleCircles hide(OrderedCircles ordered) {
  auto [circles, indices] = std::move(ordered);
  if (auto centres = proofOfClearance(circles)) return {std::move(circles), std::move(indices), {}, std::move(centres)};

  const std::vector<int> hider = findHiders(circles, indices);
  VisibleCircles visible;
  visible.circles.reserve(circles.size());
  visible.indices.reserve(circles.size());
  for (std::size_t i = 0; i < circles.size(); ++i) {
    if (hider[i] == kNone) {
      visible.circles.push_back(circles[i]);
      visible.indices.push_back(indices[i]);
    } else {
      visible.hidden.push_back({indices[i], indices[hider[i]]});
    }
  }
  std::sort(visible.hidden.begin(), visible.hidden.end(),
            [](const HiddenCircle& a, const HiddenCircle& b) { return a.circle < b.circle; });
  return visible;
}

}  // namespace circle_voronoi
