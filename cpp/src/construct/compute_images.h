// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/options.h"
#include "circle_voronoi/periodic_diagram.h"

namespace circle_voronoi {

using ComputeFunction = Result<Diagram>(std::span<const Circle>, const Options&);

/// Computes a periodic diagram as `computePeriodic` promises. `compute` computes the diagrams of circles and images: a
/// module without some metrics passes a function that has no code for them.
CIRCLE_VORONOI_API Result<PeriodicDiagram> computeImages(std::span<const Circle> circles, const Lattice& lattice,
                                                         const Options& options, ComputeFunction& compute);

}  // namespace circle_voronoi
