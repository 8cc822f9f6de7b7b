// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/abi.h"
#include "circle_voronoi/certificate.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"

namespace circle_voronoi {

/// Judges whether a diagram is the Voronoi diagram of its circles, whatever program made it. Linear time.
///
/// All signs are exact: a diagram is certified if and only if its topology is right. Edges of length zero may point
/// either way. The vertices must be right up to rounding: the center and the radius of each vertex touch its three
/// circles to 40 bits, relative to the larger of the disc and the coordinates. Two distinct vertices may have equal
/// coordinates.
///
/// Numbers of circles are at most 2^96 (7.9e28) in absolute value. Each is rounded once to a multiple of 2^-96
/// (1.3e-29), as every number from 2^-44 (5.7e-14) up already is, and the certificate is about the rounded circles. If
/// the largest number is not 0 and below 2^-56 (1.4e-17), there is an error.
///
/// The 36 bits that `compute` promises are another measure: they bound the distance of a vertex from its exact place.
/// If three circles nearly share a tangent line, points far from the true vertex touch the circles to 40 bits, too. A
/// diagram from any program can reach 40 bits. The vertices of `compute` always pass.
///
/// `certify` reads everything but `stats` and the diagram's own `certificate`. The links must equal the result of
/// `linkSides`. For Metric::centers the radii are ignored. For Metric::power, the place of a vertex is right to 40 bits
/// of its distance from its circles, and its power to 40 bits of the squares of such distances and of radii. Takes
/// linear time.
///
/// Errors: nonFinite, negativeRadius (unless the radii are weights), coordinateTooLarge, coordinateTooSmall,
/// tooManyCircles, badArithmetic, internal.
CIRCLE_VORONOI_API Result<Certificate> certify(const Diagram& diagram);

}  // namespace circle_voronoi
