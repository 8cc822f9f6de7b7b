// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/compute.h"

#include <string>
#include <utility>

#include "circle_voronoi/compute_periodic.h"
#include "compute_circles.h"
#include "compute_images.h"
#include "guarded.h"
#include "power_diagram.h"
#include "threads.h"
#include "validate.h"

namespace circle_voronoi {
namespace {

std::optional<Error> checkOptions(const Options& options) {
  const std::string diagram = "A diagram of the metric " + std::string(metricName(options.metric));
  if (options.method != Method::automatic) {
    return Error{ErrorCode::badOption, kNone, diagram + " is computed by the method auto only."};
  }
  if (options.observer) return Error{ErrorCode::badOption, kNone, diagram + " has no events to observe."};
  return Threads::refusalOf(options.threads);
}

/// The diagram of the centers. Radii are validated before they are dropped, so that errors in them are reported.
Result<Diagram> diagramOfCenters(std::span<const Circle> circles, const Options& options) {
  auto valid = validate(circles, options.weights);
  if (!valid) return valid.error();
  Options own = options;
  own.metric = Metric::circles;
  own.weights = false;
  auto diagram = computeCircles(pointsOf(valid.value()), own);
  if (!diagram) return diagram;
  diagram.value().circles = std::move(valid).value();
  diagram.value().metric = Metric::centers;
  diagram.value().weights = options.weights;
  return diagram;
}

}  // namespace

Result<Diagram> compute(std::span<const Circle> circles, const Options& options) {
  if (options.metric == Metric::circles) return computeCircles(circles, options);
  return guarded([&]() -> Result<Diagram> {
    if (auto error = checkOptions(options)) return *std::move(error);
    if (options.metric == Metric::centers) return diagramOfCenters(circles, options);
    return powerDiagram(circles, options);
  });
}

Result<PeriodicDiagram> computePeriodic(std::span<const Circle> circles, const Lattice& lattice,
                                        const Options& options) {
  return computeImages(circles, lattice, options, compute);
}

}  // namespace circle_voronoi
