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

namespace circle_voronoi {

/// Returns the largest disc that lies entirely inside a region and overlaps no circle. It may touch the boundary of the
/// region in place of circles. Without circles it is the largest disc in the region. If circles cover the region,
/// returns the disc of ClippedDiagram::largestEmptyDisc, whose radius is not positive.
///
/// Rectangles that may hold the center are divided, the most promising first, until few circles and sides are near.
/// Then the disc that touches each three of them is computed. The result is right up to rounding, and inside the
/// region: the region contains the center, and the radius is at most the distance to the boundary, up to rounding of
/// itself. For m circles and sides, it takes O(m log m) steps for most regions, ring corridors, combs, spirals and
/// streets in several directions included. It takes more where very many thin strips fan out.
///
/// Errors: badOption if the metric is not Metric::circles, or the region is so thin, a few units of rounding wide, that
/// no disc is found in it; tooManyCircles if memory runs out; the errors of ClippedDiagram::from if circles cover the
/// region.
CIRCLE_VORONOI_API Result<std::optional<EmptyDisc>> largestEmptyDiscInside(const Diagram& diagram,
                                                                           const Region& region);

/// Returns a path of greatest clearance from p to q that stays inside a region, with its curves. Returns nothing only
/// if p and q lie in different parts of the region. Polygons that touch in a point are one part, and the path may lead
/// through that point.
///
/// The clearance counts circles only. The boundary is a limit and no obstacle, so the path may run along it. To keep
/// away from the boundary, pass a smaller region. The result is the shortest of the clearest paths along edges and
/// boundary, rounding aside. From p it follows the ray from the nearest center to an edge or to the boundary (`entry`),
/// unless p lies on the boundary and the path begins there.
///
/// The path consists of parts of edges, of sides, and of rays from centers. Exact signs decide which of them lie in the
/// region and how they meet, so the path never crosses the boundary, however thin a wall is. Takes O(n log n) steps for
/// n circles, sides and crossings of the boundary with edges.
///
/// Errors: badOption if p or q lies outside the region, the metric is not Metric::circles, or there are no circles; see
/// also ClippedDiagram::from.
CIRCLE_VORONOI_API Result<std::optional<ClearestPath>> clearestPath(const Diagram& diagram, Point p, Point q,
                                                                    const Region& region);

}  // namespace circle_voronoi
