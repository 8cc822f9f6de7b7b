// SPDX-License-Identifier: GPL-3.0-or-later
#include "hide.h"

#include <algorithm>
#include <utility>

#include "delaunay.h"
#include "geometry.h"
#include "predicates.h"

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

/// For each circle a visible one that hides it, or kNone. `centres` triangulates all centres.
std::vector<int> findHiders(std::span<const Circle> circles, const Delaunay& centres) {
  const int n = static_cast<int>(circles.size());
  const Before before{circles};
  Predicates predicates(circles);

  // Of circles with one centre only the first in order can be visible; it stands for them in the triangulation.
  std::vector<int> first(n, kNone);
  for (int i = 0; i < n; ++i) {
    int& stand = first[centres.representative[i]];
    if (stand == kNone || before(i, stand)) stand = i;
  }
  std::vector<int> hider(n, kNone);
  std::vector<int> order;
  order.reserve(n);
  double smallest = n == 0 ? 0 : circles[0].r;
  for (int i = 0; i < n; ++i) {
    const int stand = first[centres.representative[i]];
    if (stand == i) {
      order.push_back(i);
    } else {
      hider[i] = stand;
    }
    smallest = std::min(smallest, circles[i].r);
  }
  std::sort(order.begin(), order.end(), before);

  // The centres that a disc around a centre contains are connected in the Delaunay graph: walk over them.
  const Neighbors neighbors(centres.dual, n);
  std::vector<int> seenBy(n, kNone);
  std::vector<int> stack;
  for (const int i : order) {
    if (hider[i] != kNone) continue;
    const double reach = circles[i].r - smallest;
    if (reach <= 0) break;
    // The walk must not stop early because of rounding; `contains` decides.
    const double reachSquared = reach * reach * (1 + 1e-12);
    stack.push_back(centres.representative[i]);
    seenBy[stack.back()] = i;
    while (!stack.empty()) {
      const int corner = stack.back();
      stack.pop_back();
      for (const int neighbor : neighbors.of(corner)) {
        if (seenBy[neighbor] == i) continue;
        seenBy[neighbor] = i;
        const int j = first[neighbor];
        const Vector v = between(circles[i], circles[j]);
        if (dot(v, v) > reachSquared) continue;
        if (hider[j] == kNone && before(i, j) && predicates.contains(circles[i], circles[j])) hider[j] = i;
        stack.push_back(neighbor);
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
  Delaunay centres = delaunay(centresOf(circles));
  const std::vector<int> hider = findHiders(circles, centres);
  Sites sites;
  for (int i = 0; i < static_cast<int>(circles.size()); ++i) {
    if (hider[i] == kNone) {
      sites.indices.push_back(i);
      sites.circles.push_back(circles[i]);
    } else {
      sites.hidden.push_back({i, hider[i]});
    }
  }
  if (!sites.hidden.empty()) centres = delaunay(centresOf(sites.circles));
  sites.centres = std::move(centres.dual);
  return sites;
}

}  // namespace circle_voronoi
