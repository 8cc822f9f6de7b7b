// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/diagram.h"

namespace circle_voronoi {

/// Returns a sentence for the user if more than a quarter of the circles of a diagram are hidden, because radii in
/// another unit than the coordinates hide most circles. Otherwise, and for other metrics than Metric::circles, returns
/// an empty text: by these, circles without a cell need not be hidden inside others.
[[nodiscard]] CIRCLE_VORONOI_API std::string hiddenWarning(const Diagram& diagram);

}  // namespace circle_voronoi
