// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/comparison.h"

#include <vector>

#include "circle_voronoi/compute.h"
#include "guarded.h"
#include "power_diagram.h"
#include "validate.h"

namespace circle_voronoi {

Result<Diagram> computeComparison(std::span<const Circle> circles, Metric metric) {
  if (metric == Metric::circles) return compute(circles);
  return guarded([&]() -> Result<Diagram> {
    if (metric == Metric::power) return powerDiagram(circles);
    // Without radii nobody would see what is wrong with them.
    const auto scaled = validate(circles);
    if (!scaled) return scaled.error();
    std::vector<Circle> centres(circles.begin(), circles.end());
    for (Circle& c : centres) c.r = 0;
    return compute(centres);
  });
}

}  // namespace circle_voronoi
