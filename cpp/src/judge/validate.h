// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"

namespace circle_voronoi {

/// The input circles times a power of two that brings the largest magnitude near 2^80, so that no product of the
/// later stages overflows, and underflow needs features 2^250 times smaller than the whole. The scaling is exact
/// unless a value is smaller than the largest by a factor of about 2^1000.
struct ScaledCircles {
  std::vector<Circle> circles;
  double unit = 1;  ///< input = scaled * unit, a power of two
};

/// Errors: nonFinite, negativeRadius unless radii are weights (Options::weights), coordinateTooLarge, tooManyCircles,
/// badArithmetic. They number circles from `first`, for those who have a part of the input. The readers, a library of
/// their own, ask this too.
CIRCLE_VORONOI_API Result<ScaledCircles> validate(std::span<const Circle> circles, bool weights = false,
                                                  std::size_t first = 0);
/// A number is no `weights`.
void validate(std::span<const Circle> circles, std::size_t first) = delete;

/// A disc of scaled circles in the unit of the input: none, which is NaN, if it is beyond the doubles.
Vertex discOfInput(const Vertex& disc, double unit);

/// The centres as circles of radius 0.
std::vector<Circle> pointsOf(std::span<const Circle> circles);

}  // namespace circle_voronoi
