// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/options.h"

namespace circle_voronoi {

/// Computes the diagram of circles, like `compute` with Metric::circles, for what does without the other metrics.
CIRCLE_VORONOI_API Result<Diagram> computeCircles(std::span<const Circle> circles, const Options& options = {});

}  // namespace circle_voronoi
