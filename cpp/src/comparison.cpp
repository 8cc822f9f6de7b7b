// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/comparison.h"

#include <vector>

#include "circle_voronoi/compute.h"
#include "power_diagram.h"
#include "validate.h"

namespace circle_voronoi {

Result<Diagram> computeComparison(std::span<const Circle> circles, Metric metric) {
  if (metric == Metric::circles) return compute(circles);
  const auto scaled = validate(circles);
  if (!scaled) return scaled.error();
  if (metric == Metric::centres) {
    std::vector<Circle> centres(circles.begin(), circles.end());
    for (Circle& c : centres) c.r = 0;
    return compute(centres);
  }
  Diagram diagram = powerDiagram(scaled.value().circles);
  const double unit = scaled.value().unit;
  for (auto& [x, y, radius] : diagram.vertices) {
    x *= unit;
    y *= unit;
    radius *= unit;
  }
  return diagram;
}

}  // namespace circle_voronoi
