// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/comparison.h"

#include "circle_voronoi/compute.h"
#include "guarded.h"
#include "validate.h"

namespace circle_voronoi {

Result<Diagram> computeComparison(std::span<const Circle> circles, Metric metric) {
  if (metric == Metric::circles) return compute(circles);
  if (metric == Metric::power) return powerDiagram(circles);
  return guarded([&]() -> Result<Diagram> {
    // Radii are validated before they are dropped, so that errors in them are reported.
    const auto scaled = validate(circles);
    if (!scaled) return scaled.error();
    auto diagram = compute(pointsOf(circles));
    if (!diagram) return diagram;
    diagram.value().circles.assign(circles.begin(), circles.end());
    diagram.value().metric = metric;
    return diagram;
  });
}

}  // namespace circle_voronoi
