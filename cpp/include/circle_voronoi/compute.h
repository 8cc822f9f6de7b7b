// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/options.h"

namespace circle_voronoi {

/// Computes the Voronoi diagram of `circles`.
///
/// The circles may be disjoint, intersecting, tangent, nested, equal, or points, in any position. There may be none.
/// The same input gives the same bits on every platform.
///
/// Where more than three circles touch one disc, the way their face is divided depends only on the positions of their
/// centers. It depends neither on the order of the circles nor on the method.
///
/// Numbers are at most 2^96 (7.9e28) in absolute value. Each is rounded once to a multiple of 2^-96 (1.3e-29), as every
/// number from 2^-44 (5.7e-14) up already is. The circles of the diagram are the rounded ones, and so is the
/// certificate about them. If the largest number is not 0 and below 2^-56 (1.4e-17), there is an error.
///
/// A point belongs to the circle with the smallest distance minus radius, so only the differences of the radii matter.
/// With `weights` they may be negative. If you add the same number to all radii, the topology and the coordinates of
/// the vertices keep their bits, and the radii of the vertices decrease by that number. This requires that the sums do
/// not round. The order of vertices and edges may change.
///
/// In another metric (Options::metric), the result is the diagram of the same circles by another distance. For
/// Metric::centers the radius of a vertex is its distance from its three centers, and circles that share a center are
/// hidden by the first of them. Metric::power gives the power (Laguerre) diagram, whose cells have straight borders.
/// The radius of its vertex is that of the circle orthogonal to the vertex's three circles, or minus the root of minus
/// their power where these overlap. A circle without a cell is hidden by a visible one whose center is a corner of the
/// Delaunay triangle around its own center; no single circle need contain it. The center of a circle may lie outside
/// its cell. Weights are exact: squares of radii are not rounded. Both metrics have one method only, `automatic`, and
/// no events.
///
/// With `automatic` the result is certified, or there is an error. With the other methods the diagram comes with its
/// certificate and may be wrong where the certificate says so.
///
/// `automatic` takes about n log n steps for n circles.
///
/// Vertices are at their exact places to 36 bits of their distances from their circles (certify.h says why it asks for
/// 40).
///
/// Errors: nonFinite, negativeRadius (without `weights`), coordinateTooLarge (these three name the first such circle),
/// coordinateTooSmall, badOption (also for an observer or another method in another metric), tooManyCircles,
/// notCertified, badArithmetic, internal.
CIRCLE_VORONOI_API Result<Diagram> compute(std::span<const Circle> circles, const Options& options = {});

}  // namespace circle_voronoi
