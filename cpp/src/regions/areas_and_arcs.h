// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "circle_voronoi/clipped_diagram.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// Returns what ClippedDiagram::areas returns, and calls `visit` with each part of an edge inside the region, so that
/// its curve is computed once for both. There is no maximum distance.
///
/// Exported because the library for fits calls it.
std::vector<double> areasAndArcs(const ClippedDiagram& clipped,
                                 const std::function<void(const Edge&, const EdgeCurve&)>& visit);

}  // namespace circle_voronoi
