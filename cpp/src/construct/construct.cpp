// SPDX-License-Identifier: GPL-3.0-or-later
#include "construct.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include "apollonius.h"
#include "certificate_message.h"
#include "flip.h"
#include "insert.h"
#include "judge.h"
#include "pair.h"
#include "repair.h"
#include "sample.h"
#include "settle_ties.h"
#include "tell_faces.h"
#include "touch.h"
#include "triangulate.h"

namespace circle_voronoi {
namespace {

void addCounts(const FilterCounts& signs, Counts& counts) {
  counts.filtered += signs.filtered;
  counts.refined += signs.refined;
  counts.inCircle += signs.inCircle;
  counts.exact += signs.exact;
}

void addCounts(const Predicates& predicates, Counts& counts) { addCounts(predicates.counts(), counts); }

Construction judged(Dual& dual, std::span<const Circle> circles, Journal& journal) {
  const Stopwatch watch = journal.enter(Stage::certify);
  Predicates predicates(circles);
  const Verdict verdict = judge(circles, dual, predicates);
  addCounts(predicates, journal.stats.counts);
  settleTies(dual, verdict.ties, circles);
  Topology topology = topologyOf(dual, static_cast<int>(circles.size()));
  Certificate certificate = certificateOf(verdict, dual, topology);
  return {std::move(topology), std::move(certificate)};
}

/// A topology of `touch` need not be a triangulated sphere. Tells what ties change.
Construction judged(Topology topology, const Sites& sites, const Observer& observer, Journal& journal) {
  auto dual = dualOf(topology, static_cast<int>(sites.circles.size()));
  if (auto* fitting = std::get_if<Dual>(&dual)) {
    FaceTeller teller(*fitting, sites.circles, observer);
    teller.know();
    Construction result = judged(*fitting, sites.circles, journal);
    teller.tellChanges();
    return result;
  }
  const auto& misfit = std::get<Misfit>(dual);
  return {std::move(topology), {misfit.flaw, misfit.circle, misfit.vertex, misfit.edge, {}}};
}

void tellOfCenters(const Dual& centers, const Observer& observer) {
  for (int h = 0; h < centers.halfEdgeCount(); ++h) {
    const int i = centers.origin[h];
    const int j = centers.target(h);
    // Each edge once; kPointAtInfinity is below the indices of circles.
    if (i != kPointAtInfinity && i < j) observer({TraceKind::centersJoined, {}, {i, j, kNone}, kNone});
  }
}

void tellOfSamples(const Samples& samples, const Observer& observer) {
  for (std::size_t k = 0; k < samples.points.size(); ++k) {
    const auto& [x, y] = samples.points[k];
    observer({TraceKind::sampleTaken, {x, y, 0}, {samples.circles[k], kNone, kNone}, kNone});
  }
}

void tellOfPairs(std::span<const Pair> pairs, const Observer& observer) {
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

/// The discs of a dual after flips, and the faces that these have left wrong.
struct FlippedFaces {
  FaceDiscs discs;
  std::vector<int> wrong;
};

FlippedFaces flipFaces(Dual& dual, Predicates& predicates, const Sites& sites, FaceTeller& teller, Journal& journal) {
  const Stopwatch watch = journal.enter(Stage::flip);
  FaceDiscs discs(sites.circles, dual, predicates);
  Flips flips = flip(dual, discs, teller.watcher());
  journal.stats.counts.flips += flips.count;
  return {std::move(discs), std::move(flips.wrong)};
}

/// A dual flipped and judged, and all that told.
Construction flippedAndJudged(Dual& dual, const Sites& sites, FaceTeller& teller, Journal& journal) {
  teller.tellChanges();
  Predicates predicates(sites.circles);
  flipFaces(dual, predicates, sites, teller, journal);
  addCounts(predicates, journal.stats.counts);
  Construction result = judged(dual, sites.circles, journal);
  teller.tellChanges();
  return result;
}

/// The circles at what a certificate found wrong and their neighbours among the centres; all if it names none.
std::vector<int> circlesAround(const Construction& construction, const Dual& centres) {
  const auto& [topology, certificate] = construction;
  std::set<int> named;
  if (certificate.circle != kNone) named.insert(certificate.circle);
  if (certificate.vertex != kNone) {
    const auto& triple = topology.vertexCircles[certificate.vertex];
    named.insert(triple.begin(), triple.end());
  }
  if (certificate.edge != kNone) {
    named.insert({topology.edges[certificate.edge].left, topology.edges[certificate.edge].right});
  }
  std::set<int> around = named;
  for (int h = 0; h < centres.halfEdgeCount(); ++h) {
    const int i = centres.origin[h];
    if (i != kPointAtInfinity && (named.empty() || named.contains(centres.target(h)))) around.insert(i);
  }
  return {around.begin(), around.end()};
}

constexpr int kMostResamplings = 4;
/// In the angles of Delaunay faces, of which a circle has six on average.
constexpr std::int64_t kMostAngularSamples = 4'000'000;
constexpr int kAllPairsPatch = 64;
constexpr std::size_t kLargestPatch = 256;
constexpr std::size_t kFewWrongFaces = 100;

/// The dual by insertion, and by flips where a near tie misled it.
std::optional<Dual> inserted(std::span<const Circle> circles, Counts& counts) {
  Predicates predicates(circles);
  auto result = insertAll(circles, predicates);
  if (result) {
    FaceDiscs discs(circles, result->dual, predicates);
    counts.flips += result->flips + flip(result->dual, discs).count;
  }
  addCounts(predicates, counts);
  if (!result) return std::nullopt;
  return std::move(result->dual);
}

/// The whole dual by insertion.
std::optional<Dual> insertedAll(const Sites& sites, Journal& journal) {
  const Stopwatch watch = journal.enter(Stage::flip);
  return inserted(sites.circles, journal.stats.counts);
}

/// Repairs a dual in patches that grow until none is seen to be wrong.
void repairAll(Dual& dual, FaceDiscs& discs, std::vector<int>& wrong, Journal& journal) {
  const Stopwatch watch = journal.enter(Stage::repair);
  journal.stats.way = Way::repair;
  for (const int reach : {2, 4, 8, 16}) {
    if (wrong.empty()) break;
    journal.stats.counts.repairs += repair(
        dual, discs, wrong, reach, [&](std::span<const Circle> circles) { return solveLocally(circles, journal); });
  }
}

/// Flips the centres' triangulation, and repairs it where that leaves it wrong. Whether not too much is.
bool flipAndRepair(Dual& dual, const Sites& sites, FaceTeller& teller, Journal& journal) {
  Predicates predicates(sites.circles);
  auto [discs, wrong] = flipFaces(dual, predicates, sites, teller, journal);
  // A patch takes as long as the insertion of hundreds of circles.
  const bool isMuch = wrong.size() > kFewWrongFaces + sites.circles.size() / 100;
  if (!wrong.empty() && !isMuch) repairAll(dual, discs, wrong, journal);
  addCounts(predicates, journal.stats.counts);
  return !isMuch;
}

}  // namespace

std::optional<Dual> solveLocally(std::span<const Circle> circles, Journal& journal) {
  if (circles.size() > kLargestPatch) return std::nullopt;
  const Sites sites = triangulate(hide(order(circles)));
  const int n = static_cast<int>(sites.circles.size());
  const auto isRight = [&](const Dual& candidate) {
    Predicates predicates(sites.circles);
    const bool right = judge(sites.circles, candidate, predicates).isRight();
    addCounts(predicates, journal.stats.counts);
    return right;
  };
  std::optional<Dual> dual;
  if (n <= kAllPairsPatch) {
    auto touched = dualOf(touch(sites.circles, pairAll(n), {}).topology, n);
    if (auto* fitting = std::get_if<Dual>(&touched)) dual = std::move(*fitting);
  } else {
    dual = inserted(sites.circles, journal.stats.counts);
  }
  if (!dual || !isRight(*dual)) {
    dual = apolloniusGraph(sites.circles);
    if (!isRight(*dual)) return std::nullopt;
  }
  for (int& corner : dual->origin) {
    if (corner != kPointAtInfinity) corner = sites.indices[corner];
  }
  return dual;
}

Construction constructByTouchingDisc(const Sites& sites, const Options& options, const Observer& observer,
                                     Journal& journal) {
  const int n = static_cast<int>(sites.circles.size());
  std::vector<int> angular(n, *options.samples);
  journal.stats.way = Way::touchingDisc;
  for (int round = 0;; ++round) {
    if (observer) observer({TraceKind::roundBegun, {}, {kNone, kNone, kNone}, kNone, {round, kNone}});
    Samples samples;
    if (options.candidates != Candidates::allPairs) {
      const Stopwatch watch = journal.enter(Stage::sample);
      const auto tell = [&](double done) { journal.tell(Stage::sample, done); };
      const bool isDynamic = options.candidates == Candidates::dynamic;
      if (observer && isDynamic) tellOfCenters(sites.centres, observer);
      samples = isDynamic ? sampleDynamically(sites.circles, sites.centres, angular, tell)
                          : sampleUniformly(sites.circles, *options.samples, tell);
      journal.stats.counts.samples = static_cast<std::int64_t>(samples.points.size());
      if (observer) tellOfSamples(samples, observer);
    }
    std::vector<Pair> pairs;
    {
      const Stopwatch watch = journal.enter(Stage::pair);
      pairs = options.candidates == Candidates::allPairs
                  ? pairAll(n)
                  : pairNeighbors(
                        samples, n, [&](double done) { journal.tell(Stage::pair, done); }, observer);
      if (observer) tellOfPairs(pairs, observer);
    }
    Construction result = judged(touchPairs(sites.circles, pairs, observer, journal), sites, observer, journal);
    const bool mayResample = options.resample && options.candidates == Candidates::dynamic && round < kMostResamplings;
    if (result.certificate.certified() || !mayResample) return result;
    ++journal.stats.counts.resamplings;
    // Where only rounding put the ends of an edge out of order, flips settle it; else pairs are missing.
    auto dual = dualOf(result.topology, n);
    if (auto* fitting = std::get_if<Dual>(&dual)) {
      FaceTeller teller(*fitting, sites.circles, observer);
      Construction flippedResult = flippedAndJudged(*fitting, sites, teller, journal);
      if (flippedResult.certificate.certified()) return flippedResult;
    }
    // What is missing may lie farther off than what is seen to be wrong: from the third try on, sample everywhere.
    if (round >= 2) {
      for (int& count : angular) count = std::clamp(4 * count + 3, 15, kMaxSamples);
      if (std::accumulate(angular.begin(), angular.end(), std::int64_t{0}) > kMostAngularSamples) return result;
    } else {
      for (const int i : circlesAround(result, sites.centres)) angular[i] = 2 * angular[i] + 1;
    }
  }
}

Construction constructByFlips(Sites& sites, const Observer& observer, Journal& journal) {
  journal.stats.way = Way::flip;
  FaceTeller teller(sites.centres, sites.circles, observer);
  teller.tellRound(0);
  if (observer) tellOfCenters(sites.centres, observer);
  return flippedAndJudged(sites.centres, sites, teller, journal);
}

Construction constructAutomatically(Sites& sites, const Observer& observer, Journal& journal) {
  Construction result;
  int round = 0;
  // Whether a dual is right. What is not told on the way to it is told at the end.
  const auto isCertified = [&](Dual& dual, FaceTeller& teller) {
    result = judged(dual, sites.circles, journal);
    teller.tellChanges();
    return result.certificate.certified();
  };
  const auto isRightAnew = [&](Dual& dual) {
    FaceTeller teller(dual, sites.circles, observer);
    teller.tellRound(round++);
    return isCertified(dual, teller);
  };
  if (sites.dual) {
    journal.stats.way = Way::insert;
    journal.stats.counts.flips += sites.flips;
    addCounts(sites.signs, journal.stats.counts);
    result.topology = topologyOf(*sites.dual, static_cast<int>(sites.circles.size()));
    result.certificate = certificateOf(Verdict{}, *sites.dual, result.topology);
    FaceTeller teller(*sites.dual, sites.circles, observer);
    teller.tellRound(round);
    teller.tellChanges();
    return result;
  }
  journal.stats.way = Way::flip;
  {
    Dual dual = std::move(sites.centres);
    FaceTeller teller(dual, sites.circles, observer);
    teller.tellRound(round++);
    if (observer) tellOfCenters(dual, observer);
    teller.tellChanges();
    if (flipAndRepair(dual, sites, teller, journal) && isCertified(dual, teller)) return result;
  }
  journal.stats.way = Way::insert;
  if (auto dual = insertedAll(sites, journal); dual && isRightAnew(*dual)) return result;
  journal.stats.way = Way::apolloniusGraph;
  Dual dual = apolloniusGraph(sites.circles);
  isRightAnew(dual);
  return result;
}

}  // namespace circle_voronoi
