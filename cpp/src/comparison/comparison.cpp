// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/comparison.h"

#include <utility>

#include "circle_voronoi/compute.h"
#include "guarded.h"
#include "validate.h"

namespace circle_voronoi {

Result<Diagram> computeComparison(std::span<const Circle> circles, Metric metric) {
  if (metric == Metric::circles) return compute(circles);
  if (metric == Metric::power) return powerDiagram(circles);
  return guarded([&]() -> Result<Diagram> {
    // Radii are validated before they are dropped, so that errors in them are reported.
    auto rounded = validate(circles);
    if (!rounded) return rounded.error();
    auto diagram = compute(pointsOf(rounded.value()));
    if (!diagram) return diagram;
    diagram.value().circles = std::move(rounded).value();
    diagram.value().metric = metric;
    return diagram;
  });
}

}  // namespace circle_voronoi
