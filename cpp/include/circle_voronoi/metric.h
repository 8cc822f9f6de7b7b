// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/point.h"

namespace circle_voronoi {

/// The distance from a circle that defines a diagram. A point belongs to the cell of the nearest circle.
enum class Metric {
  circles,  ///< |p - c| - r, signed: the Voronoi diagram of circles
  centers,  ///< |p - c|: the ordinary Voronoi diagram of the centers
  power,    ///< |p - c|^2 - r^2, or |p - c|^2 - w with weights: the power (Laguerre) diagram
};

/// Returns the name of a metric, as in the enumeration; past the last one it is empty.
[[nodiscard]] CIRCLE_VORONOI_API std::string_view metricName(Metric metric);
/// Returns the metric with a name; nothing if there is none.
[[nodiscard]] CIRCLE_VORONOI_API std::optional<Metric> metricFromName(std::string_view name);

/// Returns the distance of p from a circle, whose third number is its radius, or its weight (Options::weights).
[[nodiscard]] CIRCLE_VORONOI_API double distance(Metric metric, const Circle& circle, Point p, bool weights = false);

}  // namespace circle_voronoi
