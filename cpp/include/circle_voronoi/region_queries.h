// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/clearest_path.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/point.h"
#include "circle_voronoi/queries.h"
#include "circle_voronoi/region.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// Returns the largest disc that lies entirely inside a region and overlaps no circle. It may touch the boundary of the
/// region in place of circles. Without circles it is the largest disc in the region. If circles cover the region,
/// returns the disc of ClippedDiagram::largestEmptyDisc, whose radius is not positive.
///
/// Squares that may hold the center are divided, the most promising first, until few circles and sides are near. Then
/// the disc that touches each three of them is computed. The result is right up to rounding.
///
/// Errors: badOption if the metric is not Metric::circles; tooManyCircles if memory runs out; the errors of
/// ClippedDiagram::from if circles cover the region.
Result<std::optional<EmptyDisc>> largestEmptyDiscInside(const Diagram& diagram, const Region& region);

/// Returns a path of greatest clearance from p to q that stays inside a region, with its curves. Returns nothing if p
/// and q lie in different parts of the region.
///
/// The clearance counts circles only. The boundary is a limit and no obstacle, so the path may run along it. To keep
/// away from the boundary, pass a smaller region. The result is the shortest of the clearest paths along edges and
/// boundary.
///
/// Errors: badOption if p or q lies outside the region, the metric is not Metric::circles, or there are no circles; see
/// also ClippedDiagram::from.
Result<std::optional<ClearestPath>> clearestPath(const Diagram& diagram, Point p, Point q, const Region& region);

}  // namespace circle_voronoi
