// SPDX-License-Identifier: GPL-3.0-or-later
#include "find_sites.h"

#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "at.h"
#include "infinity.h"
#include "insert.h"
#include "judge.h"
#include "settle_ties.h"
#include "triangulate.h"

namespace circle_voronoi {
namespace {

constexpr std::int64_t kFewSteps = 1000;
constexpr std::int64_t kNoLimit = std::numeric_limits<std::int64_t>::max();

/// A selection of the ordered circles.
struct SomeCircles {
  std::vector<Circle> circles;
  std::vector<int> indices;
  std::vector<int> places;  ///< the place of each circle in the order

  SomeCircles(const OrderedCircles& ordered, std::vector<int> places_) : places(std::move(places_)) {
    for (const int i : places) {
      circles.push_back(ordered.circles[at(i)]);
      indices.push_back(ordered.indices[at(i)]);
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
      if (places.empty() || circles[at(i)].x != circles[at(places.back())].x ||
          circles[at(i)].y != circles[at(places.back())].y) {
        places.push_back(i);
      } else if (circles[at(i)].r > circles[at(places.back())].r) {
        places.back() = i;
      }
      which.push_back(static_cast<int>(places.size()) - 1);
    }
  }
};

/// Finds the visible circles by insertion: they keep a cell. Returns nothing if this cannot be proven.
std::optional<FoundSites> hideByInsertion(const OrderedCircles& ordered, Journal& journal, Threads threads) {
  const LargestOfEachCenter largest(ordered.circles);
  const SomeCircles apart(ordered, largest.places);
  Predicates predicatesApart(apart.circles);
  auto inserted = [&] {
    const Stopwatch watch = journal.enter(Stage::flip);
    return insertAll(apart.circles, predicatesApart);
  }();
  if (!inserted) return std::nullopt;

  // Renumber the circles that have a cell, and collect the rest. A copy of another circle gets its hider from that one.
  std::vector<int> numbers(apart.places.size(), kNone);
  std::vector<int> seen;
  std::vector<int> rest;
  std::vector<std::pair<int, int>> copies;
  for (int i = 0; i < static_cast<int>(ordered.circles.size()); ++i) {
    const int k = largest.which[at(i)];
    if (const int original = apart.places[at(k)]; i != original) {
      if (ordered.circles[at(i)].r == ordered.circles[at(original)].r) {
        copies.emplace_back(i, original);
      } else {
        rest.push_back(i);
      }
    } else if (inserted->isHidden[at(k)]) {
      rest.push_back(i);
    } else {
      numbers[at(k)] = static_cast<int>(seen.size());
      seen.push_back(i);
    }
  }
  Dual& dual = inserted->dual;
  for (int& corner : dual.origin) {
    if (corner != kPointAtInfinity) corner = numbers[at(corner)];
  }
  const SomeCircles visible(ordered, std::move(seen));
  const SomeCircles hidden(ordered, std::move(rest));

  Predicates predicates(visible.circles);
  Verdict verdict = [&] {
    const Stopwatch watch = journal.enter(Stage::certify);
    Verdict its = judge(visible.circles, dual, predicates, {}, threads);
    if (its.isRight()) settleTies(dual, its, visible.circles, predicates);
    return its;
  }();
  if (!verdict.isRight()) return std::nullopt;
  const Stopwatch watch = journal.enter(Stage::triangulate);
  const Hiders named = findHiders(visible, hidden, kNoLimit, threads);
  Hiders all{std::vector<int>(ordered.circles.size(), kNone), named.steps + inserted->flips};
  for (std::size_t j = 0; j < hidden.places.size(); ++j) {
    const int i = named.hider[j];
    if (i == kNone) return std::nullopt;
    all.hider[at(hidden.places[j])] = visible.places[at(i)];
  }
  for (const auto& [copy, original] : copies) {
    all.hider[at(copy)] = all.hider[at(original)] == kNone ? original : all.hider[at(original)];
  }
  FilterCounts signs = predicatesApart.counts();
  signs += predicates.counts();
  return FoundSites{withoutHidden(ordered, all),
                    InsertedDual{std::move(dual), std::move(verdict.proof), inserted->flips, signs}};
}

}  // namespace

FoundSites findSites(OrderedCircles ordered, Journal& journal, Threads threads, std::int64_t mostStepsACircle) {
  const auto triangulated = [&](std::int64_t mostSteps) -> std::optional<FoundSites> {
    const Stopwatch watch = journal.enter(Stage::triangulate);
    auto sites = hide(ordered, mostSteps, threads);
    if (!sites) return std::nullopt;
    return FoundSites{triangulate(*std::move(sites), threads), std::nullopt};
  };
  const std::int64_t mostSteps = kFewSteps + mostStepsACircle * static_cast<std::int64_t>(ordered.circles.size());
  if (auto found = triangulated(mostSteps)) return *std::move(found);
  if (auto found = hideByInsertion(ordered, journal, threads)) {
    found->sites.steps += mostSteps;
    return *std::move(found);
  }
  return *triangulated(kNoLimit);
}

}  // namespace circle_voronoi
