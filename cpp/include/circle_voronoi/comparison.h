// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/metric.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// Computes the diagram of the same circles in another metric, to show how it differs. Metric::centers gives the
/// ordinary Voronoi diagram of the centers, Metric::power the power diagram, and Metric::circles the diagram of
/// `compute`. Curves and cells of the result use the same metric (curve.h, cells.h).
///
/// For Metric::centers the radius of a vertex is its distance from its three centers. If circles share a center, the
/// first such circle has the cell. Takes about n log n steps for n circles, in each metric.
///
/// Errors: see `compute` or, for Metric::power, `powerDiagram`.
Result<Diagram> computeComparison(std::span<const Circle> circles, Metric metric);

/// Computes the power diagram, as the dual of CGAL's regular triangulation of the centers with weights r^2. It is exact
/// for the rounded weights. There is no certificate, but clipping to a region checks the cells that meet the region.
///
/// The radius of a vertex is that of the circle that is orthogonal to its three circles. Where these overlap, the
/// radius is negative: minus the square root of minus their power. A circle without a cell is listed as hidden by
/// kNone, because no single circle need contain it. The center of a circle may lie outside its cell.
///
/// Errors: nonFinite, negativeRadius, coordinateTooLarge, coordinateTooSmall, tooManyCircles, badArithmetic,
/// internal.
Result<Diagram> powerDiagram(std::span<const Circle> circles);

}  // namespace circle_voronoi
