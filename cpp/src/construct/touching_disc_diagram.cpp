// SPDX-License-Identifier: GPL-3.0-or-later
#include "touching_disc_diagram.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <set>
#include <utility>
#include <variant>

#include "at.h"
#include "certificate_message.h"
#include "construct.h"
#include "diagram_of.h"
#include "pair.h"
#include "sample.h"
#include "three_touch_disc.h"
#include "topology.h"
#include "touch.h"
#include "validate.h"

namespace circle_voronoi {
namespace {

constexpr int kMostResamplings = 4;
/// In the angles of Delaunay faces, of which a circle has six on average.
constexpr std::int64_t kMostAngularSamples = 4'000'000;

/// Returns the samples of a circle in each angle of its Delaunay faces (`angular`), or those of Candidates::uniform.
Samples takeSamples(const Sites& sites, const Options& options, const std::vector<int>& angular,
                    const Observer& observer, Journal& journal) {
  const Stopwatch watch = journal.enter(Stage::sample);
  const auto tell = [&](double done) { journal.tell(Stage::sample, done); };
  const bool isDynamic = options.candidates == Candidates::dynamic;
  if (observer && isDynamic) reportOfCenters(sites.centers, observer);
  Samples samples = isDynamic ? sampleDynamically(sites.circles, sites.centers, angular, tell)
                              : sampleUniformly(sites.circles, sampleCountOf(options), tell);
  journal.stats.counts.samples = static_cast<std::int64_t>(samples.points.size());
  for (std::size_t k = 0; observer && k < samples.points.size(); ++k) {
    const auto& [x, y] = samples.points[k];
    observer({TraceKind::sampleTaken, {x, y, 0}, {samples.circles[k], kNone, kNone}, kNone});
  }
  return samples;
}

std::vector<Pair> findPairs(const Sites& sites, const Options& options, const std::vector<int>& angular,
                            const Observer& observer, Journal& journal) {
  const int n = static_cast<int>(sites.circles.size());
  const bool areAll = options.candidates == Candidates::allPairs;
  const Samples samples = areAll ? Samples() : takeSamples(sites, options, angular, observer, journal);
  const Stopwatch watch = journal.enter(Stage::pair);
  const auto tell = [&](double done) { journal.tell(Stage::pair, done); };
  std::vector<Pair> pairs = areAll ? pairAll(n) : pairNeighbors(samples, n, tell, observer);
  if (observer) {
    for (const auto& [a, b] : pairs) observer({TraceKind::pairFound, {}, {a, b, kNone}, kNone});
  }
  return pairs;
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

/// Returns the circles that a certificate blames and their neighbors among the centers, or all circles if it blames
/// none.
std::set<int> circlesAround(const Certificate& certificate, const Topology& topology, const Dual& centers) {
  std::set<int> named;
  if (certificate.circle != kNone) named.insert(certificate.circle);
  if (certificate.vertex != kNone) {
    const auto& triple = topology.vertexCircles[at(certificate.vertex)];
    named.insert(triple.begin(), triple.end());
  }
  if (certificate.edge != kNone) {
    const Edge& edge = topology.edges[at(certificate.edge)];
    named.insert({edge.left, edge.right});
  }
  std::set<int> around = named;
  for (int h = 0; h < centers.halfEdgeCount(); ++h) {
    const int i = centers.origin[at(h)];
    if (i != kPointAtInfinity && (named.empty() || named.contains(centers.target(h)))) around.insert(i);
  }
  return around;
}

/// Takes more samples around the flaw of a certificate. Returns false if these are too many.
bool addSamples(std::vector<int>& angular, int round, const Certificate& certificate, const Topology& topology,
                const Dual& centers) {
  if (round < 2) {
    for (const int i : circlesAround(certificate, topology, centers)) angular[at(i)] = 2 * angular[at(i)] + 1;
    return true;
  }
  // A missing edge may lie farther off than the flaw that shows it: from the third try on, sample everywhere.
  for (int& count : angular) count = std::clamp(4 * count + 3, 15, kMaxSamples);
  return std::accumulate(angular.begin(), angular.end(), std::int64_t{0}) <= kMostAngularSamples;
}

/// Returns the diagram of a topology that forms no dual, with this certificate. Both have indices of sites.
Diagram flawedDiagram(std::span<const Circle> circles, Sites sites, Topology topology, Certificate certificate) {
  const auto toInput = [&](CircleIndex& circle) {
    if (circle != kNone) circle = sites.indices[at(circle)];
  };
  Diagram diagram;
  for (auto& triple : topology.vertexCircles) {
    const auto& [i, j, k] = triple;
    // A triple without a disc has a vertex that may be anything.
    diagram.vertices.push_back(
        vertexOf(sites.circles[at(i)], sites.circles[at(j)], sites.circles[at(k)]).value_or(Vertex{}));
    std::for_each(triple.begin(), triple.end(), toInput);
    std::rotate(triple.begin(), std::min_element(triple.begin(), triple.end()), triple.end());
  }
  for (Edge& edge : topology.edges) {
    toInput(edge.left);
    toInput(edge.right);
  }
  std::for_each(topology.hull.begin(), topology.hull.end(), toInput);
  takeTopology(diagram, std::move(topology));
  diagram.hidden = std::move(sites.hidden);
  diagram.circles.reserve(circles.size());
  for (const Circle& c : circles) diagram.circles.push_back(rounded(c));
  linkSides(diagram);
  toInput(certificate.circle);
  diagram.certificate = std::move(certificate);
  diagram.certificate.message = messageOf(diagram.certificate, diagram);
  return diagram;
}

}  // namespace

int sampleCountOf(const Options& options) {
  return options.samples.value_or(options.candidates == Candidates::uniform ? kDefaultUniformSamples
                                                                            : kDefaultDynamicSamples);
}

Diagram touchingDiscDiagram(std::span<const Circle> circles, std::vector<Circle> valid, const Options& options,
                            Journal& journal) {
  const Threads threads(options.threads);
  State state = {sitesOf(std::move(valid), false, journal, threads).sites, {}, {}};
  const Sites& sites = state.sites;
  const Observer observer = observerOfInput(options.observer, sites.indices);
  std::vector<int> angular(sites.circles.size(), sampleCountOf(options));
  journal.stats.way = Way::touchingDisc;
  journal.stats.candidates = options.candidates;
  for (int round = 0;; ++round) {
    if (observer) observer({TraceKind::roundBegun, {}, {kNone, kNone, kNone}, kNone, {round, kNone}});
    const std::vector<Pair> pairs = findPairs(sites, options, angular, observer, journal);
    Topology topology = touchPairs(sites.circles, pairs, observer, journal);
    auto dual = dualOf(topology, static_cast<int>(sites.circles.size()));
    const auto* unfit = std::get_if<TopologyFlaw>(&dual);
    Certificate certificate;  // in indices of sites
    if (unfit != nullptr) {
      certificate = {unfit->flaw, unfit->circle, unfit->vertex, unfit->edge, {}};
    } else {
      state.dual = std::move(std::get<Dual>(dual));
      FaceReporter reporter(state.dual, sites.circles, observer);
      reporter.markReported();
      state.verdict = judged(state.dual, {}, sites, reporter, journal, threads);
      certificate = certificateOf(state.verdict, state.dual, topology);
    }
    const bool mayResample = options.resample && options.candidates == Candidates::dynamic && round < kMostResamplings;
    if (!certificate.certified() && mayResample) {
      ++journal.stats.counts.resamplings;
      bool isRight = false;
      // If only rounding has put ends of edges out of order, flips correct them. Otherwise pairs are missing.
      if (unfit == nullptr) {
        Dual flipped = state.dual;
        FaceReporter reporter(flipped, sites.circles, observer);
        Verdict verdict = flippedAndJudged(flipped, sites, false, reporter, journal, threads);
        isRight = verdict.isRight();
        if (isRight) state = {std::move(state.sites), std::move(flipped), std::move(verdict)};
      }
      if (!isRight && addSamples(angular, round, certificate, topology, sites.centers)) continue;
    }
    const Stopwatch watch = journal.enter(Stage::assemble);
    if (unfit != nullptr) {
      return flawedDiagram(circles, std::move(state.sites), std::move(topology), std::move(certificate));
    }
    return diagramOf(circles, std::move(state), threads);
  }
}

}  // namespace circle_voronoi
