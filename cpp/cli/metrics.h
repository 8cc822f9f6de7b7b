// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "circle_voronoi/metric.h"

namespace circle_voronoi::cli {

/// The metrics with weights, by their names.
inline const std::map<std::string, Metric> kWeightedMetrics = {
    {std::string(metricName(Metric::circles)), Metric::circles},
    {std::string(metricName(Metric::power)), Metric::power}};

}  // namespace circle_voronoi::cli
