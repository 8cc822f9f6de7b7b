// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "circle_voronoi/compute.h"
#include "pair.h"
#include "sample.h"
#include "touching_disc.h"

namespace circle_voronoi::results {

/// Returns the diagram. Throws std::runtime_error with the error's message.
Diagram diagramOf(std::span<const Circle> circles, const Options& options = {});

/// Samples of the circles, hidden ones included, by the Delaunay triangulation of their centers.
Samples dynamicSamples(std::span<const Circle> circles, int angular);

// Returns samples to be drawn as in the paper: on the circles themselves, not on the circles less the smallest radius.
Samples drawnDynamicSamples(std::span<const Circle> circles, int angular);
Samples drawnUniformSamples(std::span<const Circle> circles, int count);

/// The candidates that dynamic samples lead to.
std::vector<Pair> dynamicPairs(std::span<const Circle> circles, int angular);

}  // namespace circle_voronoi::results
