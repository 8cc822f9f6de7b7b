// SPDX-License-Identifier: GPL-3.0-or-later
#include "compute_circles.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "construct.h"
#include "diagram_of.h"
#include "guarded.h"
#include "stopwatch.h"
#include "touching_disc_diagram.h"
#include "validate.h"

namespace circle_voronoi {
namespace {

/// An error if an option is out of its range for this many circles.
std::optional<Error> checkOptions(const Options& options, std::size_t circleCount) {
  if (options.metric != Metric::circles) {
    return errorWith(ErrorCode::badOption, "Only the metric circles is possible here.");
  }
  if (auto error = Threads::refusalOf(options.threads)) return error;
  if (options.method != Method::touchingDisc) return std::nullopt;
  if (options.candidates == Candidates::allPairs) {
    if (circleCount <= kMaxAllPairsCircles) return std::nullopt;
    return Error{ErrorCode::tooManyCircles, -1,
                 "All pairs of " + std::to_string(circleCount) + " circles are too many; the limit is " +
                     std::to_string(kMaxAllPairsCircles) + " circles."};
  }
  const int fewest = options.candidates == Candidates::uniform ? 1 : 0;
  const int samples = sampleCountOf(options);
  if (samples >= fewest && samples <= kMaxSamples) return std::nullopt;
  return Error{ErrorCode::badOption, -1,
               "The number of samples is " + std::to_string(samples) + "; with " +
                   std::string(candidatesName(options.candidates)) + " candidates it is from " +
                   std::to_string(fewest) + " to " + std::to_string(kMaxSamples) + "."};
}

Result<Diagram> computeWith(std::span<const Circle> circles, const Options& options) {
  Journal journal(options.progress);
  Stats& stats = journal.stats;
  auto valid = [&] {
    // The stage begins once the circles are known to be valid.
    const Stopwatch watch(stats.seconds.order);
    return validate(circles, options.weights);
  }();
  if (!valid) return valid.error();
  stats.method = options.method;
  stats.counts.circles = static_cast<std::int64_t>(circles.size());
  Diagram diagram = [&] {
    if (options.method == Method::touchingDisc) {
      return touchingDiscDiagram(circles, std::move(valid).value(), options, journal);
    }
    State state = construct(std::move(valid).value(), options, journal);
    const Stopwatch watch = journal.enter(Stage::assemble);
    return diagramOf(circles, std::move(state), Threads(options.threads));
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

Result<Diagram> computeCircles(std::span<const Circle> circles, const Options& options) {
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
