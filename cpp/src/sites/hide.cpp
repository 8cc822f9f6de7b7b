// SPDX-License-Identifier: GPL-3.0-or-later
#include "hide.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "centers.h"
#include "hiders.h"
#include "infinity.h"
#include "insert.h"
#include "judge.h"
#include "settle_ties.h"
#include "vectors.h"

namespace circle_voronoi {
namespace {

constexpr std::int64_t kFewSteps = 1000;
constexpr std::int64_t kNoLimit = std::numeric_limits<std::int64_t>::max();

/// Returns whether the larger of two circles, its radius reduced by `smallest`, may contain the center of the other.
bool mayReach(const Circle& a, const Circle& b, double smallest) {
  return !isLonger(between(a, b), std::max(a.r, b.r) - smallest);
}

/// Returns whether no circle, its radius reduced by `smallest`, contains the center of a neighbor in the Delaunay
/// graph. Then none hides another, because the centers that a disc around a center contains are connected in this
/// graph.
bool areClear(std::span<const Circle> circles, double smallest, const Delaunay& centers, Threads threads) {
  const auto isCopy = [&](std::size_t i) { return centers.representative[i] != static_cast<int>(i); };
  const Dual& dual = centers.dual;
  // Tests most edges twice. This costs less than finding out which half of an edge comes first.
  const auto isReached = [&](std::size_t h) {
    const int i = dual.origin[h];
    const int j = dual.target(static_cast<int>(h));
    return i != kPointAtInfinity && j != kPointAtInfinity && mayReach(circles[i], circles[j], smallest);
  };
  return threads.firstWhere(circles.size(), isCopy) == circles.size() &&
         threads.firstWhere(dual.origin.size(), isReached) == dual.origin.size();
}

/// Returns whether successive circles pass the same test. It is quick, and they rarely pass if circles hide one
/// another.
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
  const bool isClear = areClear(circles, smallest, centers, threads);
  return {std::move(centers), isClear};
}

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
      visible.hidden.push_back({indices[i], indices[hider[i]]});
    }
  }
  std::sort(visible.hidden.begin(), visible.hidden.end(),
            [](const HiddenCircle& a, const HiddenCircle& b) { return a.circle < b.circle; });
  return visible;
}

/// A selection of the ordered circles.
struct SomeCircles {
  std::vector<Circle> circles;
  std::vector<int> indices;
  std::vector<int> places;  ///< the place of each circle in the order

  SomeCircles(const OrderedCircles& ordered, std::vector<int> places_) : places(std::move(places_)) {
    for (const int i : places) {
      circles.push_back(ordered.circles[i]);
      indices.push_back(ordered.indices[i]);
    }
  }
  operator NumberedCircles() const { return {circles, indices}; }
};

/// The largest circle at each center. The first of equal circles hides the others.
struct LargestOfEachCenter {
  std::vector<int> places;
  std::vector<int> which;  ///< for each circle, the index in `places` of the largest one at its center

  explicit LargestOfEachCenter(std::span<const Circle> circles) {
    for (int i = 0; i < static_cast<int>(circles.size()); ++i) {
      // Circles with the same center follow one another.
      if (places.empty() || circles[i].x != circles[places.back()].x || circles[i].y != circles[places.back()].y) {
        places.push_back(i);
      } else if (circles[i].r > circles[places.back()].r) {
        places.back() = i;
      }
      which.push_back(static_cast<int>(places.size()) - 1);
    }
  }
};

/// Finds the visible circles by insertion: they keep a cell. Returns nothing if this cannot be proven.
std::optional<Sites> hideByInsertion(const OrderedCircles& ordered, Threads threads) {
  const LargestOfEachCenter largest(ordered.circles);
  const SomeCircles apart(ordered, largest.places);
  Predicates predicatesApart(apart.circles);
  auto inserted = insertAll(apart.circles, predicatesApart);
  if (!inserted) return std::nullopt;

  // Renumber the circles that have a cell, and collect the rest. A copy of another circle gets its hider from that one.
  std::vector<int> numbers(apart.places.size(), kNone);
  std::vector<int> seen;
  std::vector<int> rest;
  std::vector<std::pair<int, int>> copies;
  for (int i = 0; i < static_cast<int>(ordered.circles.size()); ++i) {
    const int k = largest.which[i];
    if (const int original = apart.places[k]; i != original) {
      if (ordered.circles[i].r == ordered.circles[original].r) {
        copies.emplace_back(i, original);
      } else {
        rest.push_back(i);
      }
    } else if (inserted->isHidden[k]) {
      rest.push_back(i);
    } else {
      numbers[k] = static_cast<int>(seen.size());
      seen.push_back(i);
    }
  }
  Dual& dual = inserted->dual;
  for (int& corner : dual.origin) {
    if (corner != kPointAtInfinity) corner = numbers[corner];
  }
  const SomeCircles visible(ordered, std::move(seen));
  const SomeCircles hidden(ordered, std::move(rest));

  Predicates predicates(visible.circles);
  Verdict verdict = judge(visible.circles, dual, predicates, {}, threads);
  if (!verdict.isRight()) return std::nullopt;
  settleTies(dual, verdict, visible.circles, predicates);
  const Hiders named = findHiders(visible, hidden, kNoLimit, threads);
  Hiders all{std::vector<int>(ordered.circles.size(), kNone), named.steps + inserted->flips};
  for (std::size_t j = 0; j < hidden.places.size(); ++j) {
    const int i = named.hider[j];
    if (i == kNone) return std::nullopt;
    all.hider[hidden.places[j]] = visible.places[i];
  }
  for (const auto& [copy, original] : copies) {
    all.hider[copy] = all.hider[original] == kNone ? original : all.hider[original];
  }
  Sites result = withoutHidden(ordered, all);
  result.dual = std::move(dual);
  result.proof = std::move(verdict.proof);
  result.flips = inserted->flips;
  result.signs = predicatesApart.counts();
  result.signs += predicates.counts();
  return result;
}

}  // namespace

Sites hide(OrderedCircles ordered, std::int64_t mostStepsACircle, Threads threads) {
  Centers centers = centersIfClear(ordered.circles, threads);
  if (centers.areClear) {
    Sites sites;
    sites.circles = std::move(ordered.circles);
    sites.indices = std::move(ordered.indices);
    sites.centers = std::move(centers.delaunay->dual);
    return sites;
  }
  const auto visible = [&](const Hiders& found) {
    Sites sites = withoutHidden(ordered, found);
    // Some circles are near one another, but none is hidden.
    if (centers.delaunay && sites.hidden.empty()) sites.centers = std::move(centers.delaunay->dual);
    return sites;
  };
  const NumberedCircles all{ordered.circles, ordered.indices};
  const auto count = static_cast<std::int64_t>(ordered.circles.size());
  const Hiders found = findHiders(all, all, kFewSteps + mostStepsACircle * count, threads);
  if (!found.hider.empty()) return visible(found);
  if (auto inserted = hideByInsertion(ordered, threads)) {
    inserted->steps += found.steps;
    return *std::move(inserted);
  }
  return visible(findHiders(all, all, kNoLimit, threads));
}

}  // namespace circle_voronoi
