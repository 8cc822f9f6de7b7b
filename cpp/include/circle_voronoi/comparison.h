// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/metric.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// The diagram of the same circles by another distance, to show how it differs: with Metric::centers the ordinary
/// Voronoi diagram of the centres, with Metric::power the power diagram, with Metric::circles that of `compute`. Curves
/// and cells of the result take the same metric (curve.h, cells.h).
///
/// Of Metric::centers: a vertex has the distance from its three centres as its radius, and of circles with one centre
/// the first has a cell. Of Metric::power: the radius of a vertex is that of the circle at right angles to its three,
/// or, negative, the root of minus their power where they overlap; a circle without a cell is listed as hidden by
/// kNone, though no circle need contain it; a circle's centre may lie outside its cell; and no certificate is made.
///
/// Errors: those of `compute`; coordinateTooLarge, if a vertex of the power diagram is beyond the range of numbers.
Result<Diagram> computeComparison(std::span<const Circle> circles, Metric metric);

}  // namespace circle_voronoi
