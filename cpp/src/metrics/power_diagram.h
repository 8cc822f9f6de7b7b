// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/options.h"

namespace circle_voronoi {

/// Computes the certified power diagram, by the options `weights`, `threads` and `progress`: `compute` with
/// Metric::power, for what does without the other metrics.
CIRCLE_VORONOI_API Result<Diagram> powerDiagram(std::span<const Circle> circles, const Options& options = {});

}  // namespace circle_voronoi
