// SPDX-License-Identifier: GPL-3.0-or-later
#include "construct.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include "at.h"
#include "flip.h"
#include "guarded.h"
#include "insert.h"
#include "judge.h"
#include "order.h"
#include "pair.h"
#include "repair.h"
#include "report_faces.h"
#include "sample.h"
#include "settle_ties.h"
#include "touch.h"
#include "triangulate.h"
#include "validate.h"

namespace circle_voronoi {
namespace {

void addCounts(const FilterCounts& signs, Counts& counts) {
  counts.filtered += signs.filtered;
  counts.refined += signs.refined;
  counts.inCircle += signs.inCircle;
  counts.exact += signs.exact;
}

void addCounts(const Predicates& predicates, Counts& counts) { addCounts(predicates.counts(), counts); }

/// Judges a dual, given the known part of its proof, and settles its ties.
Verdict judged(Dual& dual, Proof proof, std::span<const Circle> circles, Journal& journal, Threads threads) {
  const Stopwatch watch = journal.enter(Stage::certify);
  Predicates predicates(circles);
  Verdict verdict = judge(circles, dual, predicates, std::move(proof), threads);
  settleTies(dual, verdict, circles, predicates);
  // The amount of work before a flaw is found depends on the threads.
  if (verdict.isRight()) addCounts(predicates, journal.stats.counts);
  return verdict;
}

/// A topology of `touch` need not be a triangulated sphere. Tells what ties change.
Construction judged(Topology topology, const Sites& sites, const Observer& observer, Journal& journal,
                    Threads threads) {
  auto dual = dualOf(topology, static_cast<int>(sites.circles.size()));
  if (auto* fitting = std::get_if<Dual>(&dual)) {
    FaceReporter reporter(*fitting, sites.circles, observer);
    reporter.markReported();
    Verdict verdict = judged(*fitting, {}, sites.circles, journal, threads);
    reporter.reportChanges();
    return {std::move(*fitting), std::move(verdict)};
  }
  return {{}, {}, FlawedTopology{std::move(topology), std::get<TopologyFlaw>(dual)}};
}

void reportOfCenters(const Dual& centers, const Observer& observer) {
  for (int h = 0; h < centers.halfEdgeCount(); ++h) {
    const int i = centers.origin[at(h)];
    const int j = centers.target(h);
    // Each edge once; kPointAtInfinity is below the indices of circles.
    if (i != kPointAtInfinity && i < j) observer({TraceKind::centersJoined, {}, {i, j, kNone}, kNone});
  }
}

void reportOfSamples(const Samples& samples, const Observer& observer) {
  for (std::size_t k = 0; k < samples.points.size(); ++k) {
    const auto& [x, y] = samples.points[k];
    observer({TraceKind::sampleTaken, {x, y, 0}, {samples.circles[k], kNone, kNone}, kNone});
  }
}

void reportOfPairs(std::span<const Pair> pairs, const Observer& observer) {
  for (const auto& [a, b] : pairs) observer({TraceKind::pairFound, {}, {a, b, kNone}, kNone});
}

Topology touchPairs(std::span<const Circle> circles, const std::vector<Pair>& pairs, const Observer& observer,
                    Journal& journal) {
  const Stopwatch watch = journal.enter(Stage::touch);
  TouchResult touched = touch(circles, pairs, observer, [&journal](double done) { journal.tell(Stage::touch, done); });
  journal.stats.counts.antipodalDiscs = static_cast<std::int64_t>(pairs.size());
  journal.stats.counts.threeTouchDiscs = touched.threeTouchDiscs;
  journal.stats.counts.events = touched.events;
  journal.stats.counts.leftoverCycles = touched.leftoverCycles;
  return std::move(touched.topology);
}

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

/// Flips a dual, repairs it if `mayRepair`, judges it, and tells the observer of each change. The dual is not judged if
/// too much is left to repair.
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
  Verdict verdict = judged(dual, discs.takeProof(), sites.circles, journal, threads);
  reporter.reportChanges();
  return verdict;
}

/// Flips from the triangulation of the centers, which it uses up.
Construction flippedFromCenters(Sites& sites, bool mayRepair, const Observer& observer, Journal& journal,
                                Threads threads) {
  journal.stats.way = Way::flip;
  FaceReporter reporter(sites.centers, sites.circles, observer);
  reporter.reportRound(0);
  if (observer) reportOfCenters(sites.centers, observer);
  Verdict verdict = flippedAndJudged(sites.centers, sites, mayRepair, reporter, journal, threads);
  return {std::move(sites.centers), std::move(verdict)};
}

/// Returns the circles that the judge blames and their neighbors among the centers, or all circles if it blames none.
std::vector<int> circlesAround(const Construction& construction, const Dual& centers) {
  std::set<int> named;
  if (construction.flawed) {
    const auto& [topology, found] = *construction.flawed;
    if (found.circle != kNone) named.insert(found.circle);
    if (found.vertex != kNone) {
      const auto& triple = topology.vertexCircles[at(found.vertex)];
      named.insert(triple.begin(), triple.end());
    }
    if (found.edge != kNone) named.insert({topology.edges[at(found.edge)].left, topology.edges[at(found.edge)].right});
  } else {
    const auto& [dual, verdict, flawed] = construction;
    if (verdict.circle != kNone) named.insert(verdict.circle);
    if (verdict.face != kNone && dual.isFinite(verdict.face)) {
      const auto corners = cornersOf(dual, 3 * verdict.face);
      named.insert(corners.begin(), corners.end());
    }
    if (const int h = verdict.halfEdge;
        h != kNone && dual.origin[at(h)] != kPointAtInfinity && dual.target(h) != kPointAtInfinity) {
      named.insert({dual.origin[at(h)], dual.target(h)});
    }
  }
  std::set<int> around = named;
  for (int h = 0; h < centers.halfEdgeCount(); ++h) {
    const int i = centers.origin[at(h)];
    if (i != kPointAtInfinity && (named.empty() || named.contains(centers.target(h)))) around.insert(i);
  }
  return {around.begin(), around.end()};
}

constexpr int kMostResamplings = 4;
/// In the angles of Delaunay faces, of which a circle has six on average.
constexpr std::int64_t kMostAngularSamples = 4'000'000;

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

/// Runs the touching disc method on the candidates of `options` and judges the result. With `options.resample`, tries
/// again with more samples around the flaw. Events go to `observer`, in sites and scaled units.
Construction constructByTouchingDisc(const Sites& sites, const Options& options, const Observer& observer,
                                     Journal& journal, Threads threads) {
  const int n = static_cast<int>(sites.circles.size());
  const int sampleCount = sampleCountOf(options);
  std::vector<int> angular(sites.circles.size(), sampleCount);
  journal.stats.way = Way::touchingDisc;
  journal.stats.candidates = options.candidates;
  for (int round = 0;; ++round) {
    if (observer) observer({TraceKind::roundBegun, {}, {kNone, kNone, kNone}, kNone, {round, kNone}});
    Samples samples;
    if (options.candidates != Candidates::allPairs) {
      const Stopwatch watch = journal.enter(Stage::sample);
      const auto tell = [&](double done) { journal.tell(Stage::sample, done); };
      const bool isDynamic = options.candidates == Candidates::dynamic;
      if (observer && isDynamic) reportOfCenters(sites.centers, observer);
      samples = isDynamic ? sampleDynamically(sites.circles, sites.centers, angular, tell)
                          : sampleUniformly(sites.circles, sampleCount, tell);
      journal.stats.counts.samples = static_cast<std::int64_t>(samples.points.size());
      if (observer) reportOfSamples(samples, observer);
    }
    std::vector<Pair> pairs;
    {
      const Stopwatch watch = journal.enter(Stage::pair);
      pairs = options.candidates == Candidates::allPairs
                  ? pairAll(n)
                  : pairNeighbors(
                        samples, n, [&](double done) { journal.tell(Stage::pair, done); }, observer);
      if (observer) reportOfPairs(pairs, observer);
    }
    Construction result =
        judged(touchPairs(sites.circles, pairs, observer, journal), sites, observer, journal, threads);
    const bool mayResample = options.resample && options.candidates == Candidates::dynamic && round < kMostResamplings;
    if (result.isRight() || !mayResample) return result;
    ++journal.stats.counts.resamplings;
    // If only rounding has put ends of edges out of order, flips correct them. Otherwise pairs are missing.
    if (!result.flawed) {
      Dual dual = result.dual;
      FaceReporter reporter(dual, sites.circles, observer);
      Verdict verdict = flippedAndJudged(dual, sites, false, reporter, journal, threads);
      if (verdict.isRight()) return {std::move(dual), std::move(verdict)};
    }
    // A missing edge may lie farther off than the flaw that shows it: from the third try on, sample everywhere.
    if (round >= 2) {
      for (int& count : angular) count = std::clamp(4 * count + 3, 15, kMaxSamples);
      if (std::accumulate(angular.begin(), angular.end(), std::int64_t{0}) > kMostAngularSamples) return result;
    } else {
      for (const int i : circlesAround(result, sites.centers)) angular[at(i)] = 2 * angular[at(i)] + 1;
    }
  }
}

/// Returns the first certified dual. If none is certified, returns the last one, with its verdict. Uses up the
/// triangulation of the sites, because flips change it in place. A dual that insertion made is certified already.
Construction constructAutomatically(Sites& sites, std::optional<InsertedDual> inserted, const Observer& observer,
                                    Journal& journal, Threads threads) {
  if (inserted) {
    journal.stats.way = Way::insert;
    journal.stats.counts.flips += inserted->flips;
    addCounts(inserted->signs, journal.stats.counts);
    Construction result = {std::move(inserted->dual), {}};
    result.verdict.proof = std::move(inserted->proof);
    FaceReporter reporter(result.dual, sites.circles, observer);
    reporter.reportRound(0);
    reporter.reportChanges();
    return result;
  }
  Construction result = flippedFromCenters(sites, true, observer, journal, threads);
  if (result.isRight()) return result;
  journal.stats.way = Way::insert;
  auto anew = [&] {
    const Stopwatch watch = journal.enter(Stage::flip);
    return insertedDual(sites.circles, journal.stats.counts);
  }();
  if (!anew) return result;
  result.dual = std::move(anew->dual);
  FaceReporter reporter(result.dual, sites.circles, observer);
  reporter.reportRound(1);
  result.verdict = judged(result.dual, std::move(anew->proof), sites.circles, journal, threads);
  reporter.reportChanges();
  return result;
}

/// Translates the events of visible circles to those of the input.
Observer observerOfInput(const Observer& observer, const std::vector<int>& visible) {
  if (!observer) return {};
  return [&observer, &visible](TraceEvent event) {
    for (CircleIndex& circle : event.circles) {
      if (circle != kNone) circle = visible[at(circle)];
    }
    observer(event);
  };
}

}  // namespace

int sampleCountOf(const Options& options) {
  return options.samples.value_or(options.candidates == Candidates::uniform ? kDefaultUniformSamples
                                                                            : kDefaultDynamicSamples);
}

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

Construction constructByFlips(Sites& sites, const Observer& observer, Journal& journal, Threads threads) {
  return flippedFromCenters(sites, false, observer, journal, threads);
}

State construct(std::vector<Circle> circles, const Options& options, Journal& journal) {
  const Threads threads(options.threads);
  OrderedCircles ordered = [&] {
    const Stopwatch watch = journal.enter(Stage::order);
    return order(circles, threads);
  }();
  FoundSites found = findSites(std::move(ordered), journal, threads);
  State state = {std::move(found.sites), {}};
  Sites& sites = state.sites;
  if (found.inserted && options.method != Method::automatic) {
    // Another method makes a dual of its own.
    const Stopwatch watch = journal.enter(Stage::triangulate);
    sites = triangulate(std::move(sites), threads);
  }
  if (auto error = refusalOfHidden(circles, sites.hidden)) throw ThrownError{*std::move(error)};
  circles = std::vector<Circle>();  // the sites have them
  journal.stats.counts.hidden = static_cast<std::int64_t>(sites.hidden.size());
  const Observer observer = observerOfInput(options.observer, sites.indices);
  switch (options.method) {
    case Method::automatic:
      state.construction = constructAutomatically(sites, std::move(found.inserted), observer, journal, threads);
      break;
    case Method::flip:
      state.construction = constructByFlips(sites, observer, journal, threads);
      break;
    case Method::touchingDisc:
      state.construction = constructByTouchingDisc(sites, options, observer, journal, threads);
      break;
  }
  return state;
}

}  // namespace circle_voronoi
