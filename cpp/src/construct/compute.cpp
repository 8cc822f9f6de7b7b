// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/compute.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "construct.h"
#include "diagram_of.h"
#include "find_sites.h"
#include "guarded.h"
#include "order.h"
#include "stopwatch.h"
#include "triangulate.h"
#include "validate.h"

namespace circle_voronoi {
namespace {

int sampleCount(const Options& options) {
  return options.samples.value_or(options.candidates == Candidates::uniform ? kDefaultUniformSamples
                                                                            : kDefaultDynamicSamples);
}

/// An error if an option is out of its range for this many circles.
std::optional<Error> checkOptions(const Options& options, std::size_t circleCount) {
  if (options.threads < 0) {
    return Error{ErrorCode::badOption, -1,
                 "The number of threads must not be negative (got " + std::to_string(options.threads) + ")."};
  }
  if (options.method != Method::touchingDisc) return std::nullopt;
  if (options.candidates == Candidates::allPairs) {
    if (circleCount <= kMaxAllPairsCircles) return std::nullopt;
    return Error{ErrorCode::tooManyCircles, -1,
                 "All pairs of " + std::to_string(circleCount) + " circles are too many; the limit is " +
                     std::to_string(kMaxAllPairsCircles) + " circles."};
  }
  const int fewest = options.candidates == Candidates::uniform ? 1 : 0;
  const int samples = sampleCount(options);
  if (samples >= fewest && samples <= kMaxSamples) return std::nullopt;
  return Error{ErrorCode::badOption, -1,
               "The number of samples is " + std::to_string(samples) + "; with " +
                   std::string(candidatesName(options.candidates)) + " candidates it is from " +
                   std::to_string(fewest) + " to " + std::to_string(kMaxSamples) + "."};
}

/// Translates the events of visible circles to those of the input.
Observer observerOfInput(const Observer& observer, const std::vector<int>& visible) {
  if (!observer) return {};
  return [&observer, &visible](TraceEvent event) {
    for (CircleIndex& circle : event.circles) {
      if (circle != kNone) circle = visible[circle];
    }
    observer(event);
  };
}

Result<Diagram> computeWith(std::span<const Circle> circles, const Options& options) {
  const Threads threads(options.threads);
  Journal journal(options.progress);
  Stats& stats = journal.stats;
  auto valid = [&] {
    // The stage begins once the circles are known to be valid.
    const Stopwatch watch(stats.seconds.order);
    return validate(circles, options.weights);
  }();
  if (!valid) return valid.error();
  std::vector<Circle> rounded = std::move(valid).value();
  stats.method = options.method;
  stats.counts.circles = static_cast<std::int64_t>(rounded.size());
  OrderedCircles ordered;
  {
    const Stopwatch watch = journal.enter(Stage::order);
    ordered = order(rounded, threads);
  }
  FoundSites found;
  Sites& sites = found.sites;
  {
    const Stopwatch watch = journal.enter(Stage::triangulate);
    found = findSites(std::move(ordered), kMostStepsACircle, threads);
    // Another method makes a dual of its own.
    if (options.method != Method::automatic) found.inserted.reset();
    if (!found.inserted) sites = triangulate(std::move(sites), threads);
    if (auto error = refusalOfHidden(rounded, sites.hidden)) return *std::move(error);
    rounded = std::vector<Circle>();  // the sites have them
  }
  stats.counts.hidden = static_cast<std::int64_t>(sites.hidden.size());

  const Observer observer = observerOfInput(options.observer, sites.indices);
  Construction construction;
  switch (options.method) {
    case Method::automatic:
      construction = constructAutomatically(found, observer, journal, threads);
      break;
    case Method::flip:
      construction = constructByFlips(sites, observer, journal, threads);
      break;
    case Method::touchingDisc: {
      stats.candidates = options.candidates;
      Options complete = options;
      complete.samples = sampleCount(options);
      construction = constructByTouchingDisc(sites, complete, observer, journal, threads);
      break;
    }
  }
  Diagram diagram = [&] {
    const Stopwatch watch = journal.enter(Stage::assemble);
    return diagramOf(circles, std::move(construction), std::move(sites), threads);
  }();
  if (options.method == Method::automatic && !diagram.certificate.certified()) {
    return Error{ErrorCode::notCertified, diagram.certificate.circle,
                 "No construction led to a certified diagram: " + diagram.certificate.message};
  }
  diagram.weights = options.weights;
  diagram.stats = std::move(stats);
  return diagram;
}

}  // namespace

Result<Diagram> compute(std::span<const Circle> circles, const Options& options) {
  return guarded([&]() -> Result<Diagram> {
    if (auto error = checkOptions(options, circles.size())) return *std::move(error);
    Options own = options;
    own.progress = lettingThrough(options.progress);
    own.observer = lettingThrough(options.observer);
    double seconds = 0;
    auto result = [&] {
      const Stopwatch watch(seconds);
      return computeWith(circles, own);
    }();
    if (result) result.value().stats.seconds.total = seconds;
    return result;
  });
}

}  // namespace circle_voronoi
