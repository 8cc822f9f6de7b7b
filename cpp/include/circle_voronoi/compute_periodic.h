// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/options.h"
#include "circle_voronoi/periodic_diagram.h"

namespace circle_voronoi {

/// Computes the Voronoi diagram of circles in a plane with two periods. The circles may lie anywhere. They may be
/// larger than the box, hidden, also by images, and their own neighbors.
///
/// Centers and periods are rounded once, to multiples of 2^-50 of the smallest power of two that exceeds every
/// coordinate of the periods and centers, and of 2^-96 like all numbers. So each image lies exactly where the periods
/// say, and ties are settled alike everywhere.
///
/// The circles stay where they are if they lie within one and a half periods of each other, in both directions of the
/// shortest periods of the lattice. Otherwise each circle is moved by whole periods into the parallelogram of the
/// shortest periods at the origin. This also happens if two circles lie at the same place of different boxes. `shiftOf`
/// returns the shift of each circle.
///
/// The diagram of the given circles and their images is certified, and `checkPeriodic` proves that the cells of the
/// given circles fit together across the sides of the box. So they cover the plane, and no further image changes them.
/// If they do not fit together, more images are added.
///
/// Takes about n log n steps for n circles and images. The images lie within a few times the mean distance of circles
/// around the given ones, also across a gap between these and their images. Few circles need images farther away.
///
/// The progress starts anew when images are added. An observer is told of each attempt.
///
/// Errors: see `compute`; badOption if the periods are not finite, exceed kCoordinateLimit, or are zero or parallel up
/// to 2^-40 of the largest coordinate, or if an image is 2^30 periods away; tooManyCircles if the circles and their
/// images exceed kMaxCircles; notCertified if a proof fails.
CIRCLE_VORONOI_API Result<PeriodicDiagram> computePeriodic(std::span<const Circle> circles, const Lattice& lattice,
                                                           const Options& options = {});

}  // namespace circle_voronoi
