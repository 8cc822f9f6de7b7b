// SPDX-License-Identifier: GPL-3.0-or-later
#include "construct.h"

#include <cstdint>
#include <optional>
#include <utility>

#include "at.h"
#include "flip.h"
#include "guarded.h"
#include "insert.h"
#include "judge.h"
#include "order.h"
#include "repair.h"
#include "settle_ties.h"

namespace circle_voronoi {
namespace {

void addCounts(const FilterCounts& signs, Counts& counts) {
  counts.filtered += signs.filtered;
  counts.refined += signs.refined;
  counts.inCircle += signs.inCircle;
  counts.exact += signs.exact;
}

void addCounts(const Predicates& predicates, Counts& counts) { addCounts(predicates.counts(), counts); }

/// A patch takes as long as the insertion of hundreds of circles.
constexpr std::size_t kFewWrongFaces = 100;

/// Repairs a dual after flips in patches that grow until none is seen to be wrong. Returns whether not too much was.
bool repairAll(Dual& dual, FaceDiscs& discs, std::vector<int>& wrong, Journal& journal) {
  if (wrong.empty()) return true;
  if (wrong.size() > kFewWrongFaces + static_cast<std::size_t>(dual.faceCount()) / 200) return false;
  const Stopwatch watch = journal.enter(Stage::repair);
  journal.stats.way = Way::repair;
  const auto solve = [&](std::span<const Circle> circles) { return solveLocally(circles, journal.stats.counts); };
  for (const int reach : {2, 4, 8, 16}) {
    if (wrong.empty()) break;
    journal.stats.counts.repairs += repair(dual, discs, wrong, reach, solve);
  }
  return true;
}

/// Flips from the triangulation of the centers, which it uses up.
void flipFromCenters(State& state, bool mayRepair, const Observer& observer, Journal& journal, Threads threads) {
  journal.stats.way = Way::flip;
  state.dual = std::move(state.sites.centers);
  FaceReporter reporter(state.dual, state.sites.circles, observer);
  reporter.reportRound(0);
  if (observer) reportOfCenters(state.dual, observer);
  state.verdict = flippedAndJudged(state.dual, state.sites, mayRepair, reporter, journal, threads);
}

constexpr std::size_t kLargestPatch = 256;

/// A dual, and the known part of its proof.
struct Unjudged {
  Dual dual;
  Proof proof;
};

/// Builds the dual by insertion, and by flips where a near tie misled it.
std::optional<Unjudged> insertedDual(std::span<const Circle> circles, Counts& counts) {
  Predicates predicates(circles);
  auto result = insertAll(circles, predicates);
  Proof proof;
  if (result) {
    FaceDiscs discs(circles, result->dual, predicates);
    counts.flips += result->flips + flip(result->dual, discs).count;
    proof = discs.takeProof();
  }
  addCounts(predicates, counts);
  if (!result) return std::nullopt;
  return Unjudged{std::move(result->dual), std::move(proof)};
}

/// Finds the first certified dual. If none is certified, the last one stays, with its verdict. Uses up the
/// triangulation of the sites, because flips change it in place. A dual that insertion made is certified already.
void constructAutomatically(State& state, std::optional<InsertedDual> inserted, const Observer& observer,
                            Journal& journal, Threads threads) {
  if (inserted) {
    journal.stats.way = Way::insert;
    journal.stats.counts.flips += inserted->flips;
    addCounts(inserted->signs, journal.stats.counts);
    state.dual = std::move(inserted->dual);
    state.verdict.proof = std::move(inserted->proof);
    FaceReporter reporter(state.dual, state.sites.circles, observer);
    reporter.reportRound(0);
    reporter.reportChanges();
    return;
  }
  flipFromCenters(state, true, observer, journal, threads);
  if (state.verdict.isRight()) return;
  journal.stats.way = Way::insert;
  auto anew = [&] {
    const Stopwatch watch = journal.enter(Stage::flip);
    return insertedDual(state.sites.circles, journal.stats.counts);
  }();
  if (!anew) return;
  state.dual = std::move(anew->dual);
  FaceReporter reporter(state.dual, state.sites.circles, observer);
  reporter.reportRound(1);
  state.verdict = judged(state.dual, std::move(anew->proof), state.sites, reporter, journal, threads);
}

}  // namespace

std::optional<Dual> solveLocally(std::span<const Circle> circles, Counts& counts) {
  if (circles.size() > kLargestPatch) return std::nullopt;
  const OrderedCircles ordered = order(circles);
  auto solved = insertedDual(ordered.circles, counts);
  if (!solved) return std::nullopt;
  Predicates predicates(ordered.circles);
  const Verdict verdict = judge(ordered.circles, solved->dual, predicates, std::move(solved->proof));
  addCounts(predicates, counts);
  if (!verdict.isRight()) return std::nullopt;
  for (int& corner : solved->dual.origin) {
    if (corner != kPointAtInfinity) corner = ordered.indices[at(corner)];
  }
  return std::move(solved->dual);
}

void constructByFlips(State& state, const Observer& observer, Journal& journal, Threads threads) {
  flipFromCenters(state, false, observer, journal, threads);
}

State construct(std::vector<Circle> circles, const Options& options, Journal& journal) {
  const Threads threads(options.threads);
  const bool isAutomatic = options.method == Method::automatic;
  FoundSites found = sitesOf(std::move(circles), isAutomatic, journal, threads);
  State state = {std::move(found.sites), {}, {}};
  const Observer observer = observerOfInput(options.observer, state.sites.indices);
  if (isAutomatic) {
    constructAutomatically(state, std::move(found.inserted), observer, journal, threads);
  } else {
    constructByFlips(state, observer, journal, threads);
  }
  return state;
}

FoundSites sitesOf(std::vector<Circle> circles, bool mayInsert, Journal& journal, Threads threads) {
  OrderedCircles ordered = [&] {
    const Stopwatch watch = journal.enter(Stage::order);
    return order(circles, threads);
  }();
  FoundSites found = findSites(std::move(ordered), journal, threads);
  if (found.inserted && !mayInsert) {
    const Stopwatch watch = journal.enter(Stage::triangulate);
    found.sites = triangulate(std::move(found.sites), threads);
  }
  if (auto error = refusalOfHidden(circles, found.sites.hidden)) throw ThrownError{*std::move(error)};
  journal.stats.counts.hidden = static_cast<std::int64_t>(found.sites.hidden.size());
  return found;
}

Observer observerOfInput(const Observer& observer, const std::vector<int>& visible) {
  if (!observer) return {};
  return [&observer, &visible](TraceEvent event) {
    for (CircleIndex& circle : event.circles) {
      if (circle != kNone) circle = visible[at(circle)];
    }
    observer(event);
  };
}

void reportOfCenters(const Dual& centers, const Observer& observer) {
  for (int h = 0; h < centers.halfEdgeCount(); ++h) {
    const int i = centers.origin[at(h)];
    const int j = centers.target(h);
    // Each edge once; kPointAtInfinity is below the indices of circles.
    if (i != kPointAtInfinity && i < j) observer({TraceKind::centersJoined, {}, {i, j, kNone}, kNone});
  }
}

Verdict judged(Dual& dual, Proof proof, const Sites& sites, FaceReporter& reporter, Journal& journal, Threads threads) {
  Verdict verdict = [&] {
    const Stopwatch watch = journal.enter(Stage::certify);
    Predicates predicates(sites.circles);
    Verdict its = judge(sites.circles, dual, predicates, std::move(proof), threads);
    settleTies(dual, its, sites.circles, predicates);
    // The amount of work before a flaw is found depends on the threads.
    if (its.isRight()) addCounts(predicates, journal.stats.counts);
    return its;
  }();
  reporter.reportChanges();
  return verdict;
}

Verdict flippedAndJudged(Dual& dual, const Sites& sites, bool mayRepair, FaceReporter& reporter, Journal& journal,
                         Threads threads) {
  reporter.reportChanges();
  Predicates predicates(sites.circles);
  auto [discs, wrong] = [&] {
    const Stopwatch watch = journal.enter(Stage::flip);
    FaceDiscs all(sites.circles, dual, predicates, threads);
    Flips flips = flip(dual, all, reporter.watcher());
    journal.stats.counts.flips += flips.count;
    return std::pair(std::move(all), std::move(flips.wrong));
  }();
  const bool isToJudge = !mayRepair || repairAll(dual, discs, wrong, journal);
  addCounts(predicates, journal.stats.counts);
  if (!isToJudge) return {Flaw::notJudged};
  return judged(dual, discs.takeProof(), sites, reporter, journal, threads);
}

}  // namespace circle_voronoi
