// SPDX-License-Identifier: GPL-3.0-or-later
#include "hide.h"

#include <algorithm>
#include <utility>

#include "delaunay.h"
#include "geometry.h"
#include "predicates.h"
#include "spatial_order.h"

namespace circle_voronoi {
namespace {

/// Larger circles first, of equal ones the first of the input: a circle can only be hidden by one before it.
struct Before {
  std::span<const Circle> circles;
  bool operator()(int i, int j) const { return circles[i].r != circles[j].r ? circles[i].r > circles[j].r : i < j; }
};

/// The neighbours of each corner of a triangulation, in one array.
class Neighbors {
 public:
  Neighbors(const Dual& dual, std::size_t cornerCount) : first_(cornerCount + 1, 0) {
    for (int h = 0; h < dual.halfEdgeCount(); ++h) {
      if (isEdge(dual, h)) ++first_[dual.origin[h] + 1];
    }
    for (std::size_t i = 0; i < cornerCount; ++i) first_[i + 1] += first_[i];
    targets_.resize(first_.back());
    std::vector<int> next(first_.begin(), first_.end() - 1);
    for (int h = 0; h < dual.halfEdgeCount(); ++h) {
      if (isEdge(dual, h)) targets_[next[dual.origin[h]]++] = dual.target(h);
    }
  }

  std::span<const int> of(int corner) const {
    return std::span(targets_).subspan(first_[corner], first_[corner + 1] - first_[corner]);
  }

 private:
  static bool isEdge(const Dual& dual, int h) { return dual.origin[h] != kInfinity && dual.target(h) != kInfinity; }

  std::vector<int> first_;
  std::vector<int> targets_;
};

/// The circles whose disc, less the smallest radius, contains the centre of a neighbour: the others hide nothing.
std::vector<bool> mayHide(std::span<const Circle> circles, const std::vector<double>& reachSquared,
                          const Dual& centres) {
  std::vector<bool> result(circles.size(), false);
  for (int h = 0; h < centres.halfEdgeCount(); ++h) {
    const int i = centres.origin[h];
    const int j = centres.target(h);
    if (i == kInfinity || j == kInfinity) continue;
    const Vector v = between(circles[i], circles[j]);
    if (dot(v, v) <= reachSquared[i]) result[i] = true;
  }
  return result;
}

/// For each circle a visible one that hides it, or kNone. `centres` triangulates all centres.
std::vector<int> findHiders(std::span<const Circle> circles, const Delaunay& centres) {
  const int n = static_cast<int>(circles.size());
  const Before before{circles};
  std::vector<int> hider(n, kNone);

  // Of circles with one centre only the first in order can be visible; it stands for them in the triangulation.
  std::vector<int> first(n, kNone);
  for (int i = 0; i < n; ++i) {
    int& stand = first[centres.representative[i]];
    if (stand == kNone || before(i, stand)) stand = i;
  }
  double smallest = n == 0 ? 0 : circles[0].r;
  for (int i = 0; i < n; ++i) {
    const int stand = first[centres.representative[i]];
    if (stand != i) hider[i] = stand;
    smallest = std::min(smallest, circles[i].r);
  }

  // Of each corner, by the circle that stands for it: how far a centre that it hides can be, squared. Rounding must not
  // stop the walk early; `contains` decides.
  std::vector<Circle> standing(circles.begin(), circles.end());
  std::vector<double> reachSquared(n, 0);
  for (int corner = 0; corner < n; ++corner) {
    if (first[corner] == kNone) continue;
    standing[corner] = circles[first[corner]];
    const double reach = standing[corner].r - smallest;
    reachSquared[corner] = reach * reach * (1 + 1e-12);
  }
  const std::vector<bool> active = mayHide(standing, reachSquared, centres.dual);
  std::vector<int> order;
  for (int corner = 0; corner < n; ++corner) {
    if (active[corner] && first[corner] != kNone) order.push_back(corner);
  }
  if (!order.empty()) {
    std::sort(order.begin(), order.end(), [&](int a, int b) { return before(first[a], first[b]); });
    const Neighbors neighbors(centres.dual, n);
    Predicates predicates(circles);
    // The centres that a disc around a centre contains are connected in the Delaunay graph: walk over them.
    std::vector<int> seenBy(n, kNone);
    std::vector<int> stack;
    for (const int start : order) {
      const int i = first[start];
      if (hider[i] != kNone) continue;
      stack.push_back(start);
      seenBy[start] = start;
      while (!stack.empty()) {
        const int corner = stack.back();
        stack.pop_back();
        for (const int neighbor : neighbors.of(corner)) {
          if (seenBy[neighbor] == start) continue;
          seenBy[neighbor] = start;
          const Vector v = between(standing[start], standing[neighbor]);
          if (dot(v, v) > reachSquared[start]) continue;
          const int j = first[neighbor];
          if (hider[j] == kNone && before(i, j) && predicates.contains(circles[i], circles[j])) hider[j] = i;
          stack.push_back(neighbor);
        }
      }
    }
  }
  for (int i = 0; i < n; ++i) {
    // The first of a common centre may be hidden itself.
    if (hider[i] != kNone && hider[hider[i]] != kNone) hider[i] = hider[hider[i]];
  }
  return hider;
}

std::vector<Point> centresOf(std::span<const Circle> circles) {
  std::vector<Point> centres;
  centres.reserve(circles.size());
  for (const Circle& c : circles) centres.push_back({c.x, c.y});
  return centres;
}

}  // namespace

Sites hide(std::span<const Circle> circles) {
  const std::vector<int> order = spatialOrder(centresOf(circles));
  std::vector<Circle> sorted;
  sorted.reserve(order.size());
  for (const int i : order) sorted.push_back(circles[i]);

  Delaunay centres = delaunay(centresOf(sorted));
  const std::vector<int> hider = findHiders(sorted, centres);
  Sites sites;
  for (int i = 0; i < static_cast<int>(sorted.size()); ++i) {
    if (hider[i] == kNone) {
      sites.indices.push_back(order[i]);
      sites.circles.push_back(sorted[i]);
    } else {
      sites.hidden.push_back({order[i], order[hider[i]]});
    }
  }
  std::sort(sites.hidden.begin(), sites.hidden.end(),
            [](const HiddenCircle& a, const HiddenCircle& b) { return a.circle < b.circle; });
  if (!sites.hidden.empty()) centres = delaunay(centresOf(sites.circles));
  sites.centres = std::move(centres.dual);
  return sites;
}

}  // namespace circle_voronoi
