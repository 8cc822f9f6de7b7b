// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/metric.h"

#include "scale.h"

namespace circle_voronoi {

std::string_view metricName(Metric metric) {
  switch (metric) {
    case Metric::circles:
      return "circles";
    case Metric::centers:
      return "centers";
    case Metric::power:
      return "power";
  }
  return "";
}

std::optional<Metric> metricFromName(std::string_view name) {
  for (const Metric metric : {Metric::circles, Metric::centers, Metric::power}) {
    if (metricName(metric) == name) return metric;
  }
  return std::nullopt;
}

double distance(Metric metric, const Circle& circle, Point p, bool weights) {
  const double toCenter = lengthOf({p.x - circle.x, p.y - circle.y});
  switch (metric) {
    case Metric::centers:
      return toCenter;
    case Metric::power:
      return weights ? toCenter * toCenter - circle.r : (toCenter - circle.r) * (toCenter + circle.r);
    case Metric::circles:
      break;
  }
  return toCenter - circle.r;
}

}  // namespace circle_voronoi
