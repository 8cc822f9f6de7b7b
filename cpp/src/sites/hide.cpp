// SPDX-License-Identifier: GPL-3.0-or-later
#include "hide.h"

#include <algorithm>
#include <utility>

#include "delaunay.h"
#include "predicates.h"
#include "spatial_order.h"
#include "vectors.h"

namespace circle_voronoi {
namespace {

constexpr int kFanOut = 8;

/// A box around centres, and the range of their radii.
struct Box {
  Point low = {kUnknownError, kUnknownError};
  Point high = {-kUnknownError, -kUnknownError};
  double smallest = kUnknownError;
  double largest = -kUnknownError;

  void include(const Box& other) {
    low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y)};
    high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y)};
    smallest = std::min(smallest, other.smallest);
    largest = std::max(largest, other.largest);
  }

  static Box of(const Circle& c) { return {{c.x, c.y}, {c.x, c.y}, c.r, c.r}; }

  /// Whether a circle of this box may contain one of the other: false only if none does, rounding included.
  bool mayHide(const Box& other) const {
    const double reach = largest - other.smallest;
    if (reach < 0) return false;
    const double x = std::max({0.0, low.x - other.high.x, other.low.x - high.x});
    const double y = std::max({0.0, low.y - other.high.y, other.low.y - high.y});
    return x * x + y * y <= reach * reach * (1 + 1e-12);
  }
};

/// A packed tree of boxes over circles in spatial order: level 0 has a box for every kFanOut circles, each further
/// level one for every kFanOut boxes below.
class BoxTree {
 public:
  explicit BoxTree(std::span<const Circle> circles) {
    std::vector<Box> below;
    below.reserve(circles.size());
    for (const Circle& c : circles) below.push_back(Box::of(c));
    do {
      std::vector<Box> level((below.size() + kFanOut - 1) / kFanOut);
      for (std::size_t i = 0; i < below.size(); ++i) level[i / kFanOut].include(below[i]);
      levels_.push_back(level);
      below = std::move(level);
    } while (below.size() > 1);
  }

  const std::vector<Box>& leaves() const { return levels_.front(); }

  /// Calls visit(leaf) for each leaf that may hide a circle of the query, in order, until it returns false.
  template <class Visit>
  void forEachHider(const Box& query, Visit visit) const {
    descend(levels_.size() - 1, 0, query, visit);
  }

 private:
  template <class Visit>
  bool descend(std::size_t level, std::size_t node, const Box& query, Visit& visit) const {
    if (!levels_[level][node].mayHide(query)) return true;
    if (level == 0) return visit(node);
    const std::size_t end = std::min((node + 1) * kFanOut, levels_[level - 1].size());
    for (std::size_t child = node * kFanOut; child < end; ++child) {
      if (!descend(level - 1, child, query, visit)) return false;
    }
    return true;
  }

  std::vector<std::vector<Box>> levels_;
};

/// For each circle a visible one that hides it, or kNone.
std::vector<int> findHiders(std::span<const Circle> circles) {
  std::vector<int> hider(circles.size(), kNone);
  if (circles.empty()) return hider;
  // Only a larger circle hides another, or an equal one that comes first: spatial order keeps equal circles in the
  // order of the input.
  const auto isBefore = [&](int i, int j) {
    return circles[i].r != circles[j].r ? circles[i].r > circles[j].r : i < j;
  };
  const auto circlesOf = [&](std::size_t leaf) {
    return std::pair(static_cast<int>(leaf * kFanOut),
                     static_cast<int>(std::min((leaf + 1) * kFanOut, circles.size())));
  };
  const BoxTree tree(circles);
  Predicates predicates(circles);
  for (std::size_t query = 0; query < tree.leaves().size(); ++query) {
    const int first = circlesOf(query).first;
    const int last = circlesOf(query).second;
    int visible = last - first;
    tree.forEachHider(tree.leaves()[query], [&](std::size_t leaf) {
      const auto [begin, end] = circlesOf(leaf);
      for (int i = begin; i < end; ++i) {
        if (!Box::of(circles[i]).mayHide(tree.leaves()[query])) continue;
        for (int j = first; j < last; ++j) {
          if (i == j || hider[j] != kNone || !isBefore(i, j)) continue;
          const Vector v = between(circles[i], circles[j]);
          const double slack = circles[i].r - circles[j].r;
          if (dot(v, v) > slack * slack * (1 + 1e-12) || !predicates.contains(circles[i], circles[j])) continue;
          hider[j] = i;
          --visible;
        }
      }
      return visible > 0;
    });
  }
  // What hides the hider hides the hidden; hiders come before, so the chains end.
  for (int& by : hider) {
    while (by != kNone && hider[by] != kNone) by = hider[by];
  }
  return hider;
}

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
  for (int h = 0; h < dual.halfEdgeCount(); ++h) {
    const int i = dual.origin[h];
    const int j = dual.origin[dual.twin[h]];
    if (h < dual.twin[h] && i != kInfinity && j != kInfinity && mayReach(circles[i], circles[j], smallest))
      return false;
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

  double smallest = kUnknownError;
  for (const Circle& c : circles) smallest = std::min(smallest, c.r);
  if (lookClear(sorted, smallest)) {
    Delaunay centres = delaunay(centresOf(sorted));
    if (areClear(sorted, smallest, centres)) return {std::move(sorted), order, {}, std::move(centres.dual)};
  }

  const std::vector<int> hider = findHiders(sorted);
  Sites sites;
  sites.indices.reserve(order.size());
  sites.circles.reserve(order.size());
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
  sites.centres = delaunay(centresOf(sites.circles)).dual;
  return sites;
}

}  // namespace circle_voronoi
