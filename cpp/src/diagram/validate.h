// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/vertex.h"

namespace circle_voronoi {

/// The input circles times a power of two, which brings the largest magnitude near 2^80. So no product in the later
/// stages overflows. kUnderflowError (estimate.h) says from which size on underflow matters. The scaling is exact
/// unless a value is smaller than the largest by a factor of 2^1100 (Options, compute.h).
struct ScaledCircles {
  std::vector<Circle> circles;
  double unit = 1;  ///< input = scaled * unit, a power of two
};

/// The reason why a circle is invalid: a code, and the rest of a sentence that begins with the name of the circle.
struct Objection {
  ErrorCode code;
  const char* what;
};

/// Returns the objection to a circle, if any: nonFinite, negativeRadius unless radii are weights, coordinateTooLarge.
std::optional<Objection> objectionTo(const Circle& circle, bool weights);

/// Errors: nonFinite, negativeRadius unless radii are weights (Options::weights), coordinateTooLarge, tooManyCircles,
/// badArithmetic. Errors number the circles from `first`, for callers that have a part of the input. Exported because
/// the readers and writers, a library of their own, call it.
CIRCLE_VORONOI_API Result<ScaledCircles> validate(std::span<const Circle> circles, bool weights = false,
                                                  std::size_t first = 0);
/// A number must not turn into `weights`.
void validate(std::span<const Circle> circles, std::size_t first) = delete;

/// Converts a disc of scaled circles to the unit of the input. Returns NaN if a number exceeds the largest double.
Vertex discOfInput(const Vertex& disc, double unit);

/// Returns the centers as circles of radius 0.
std::vector<Circle> pointsOf(std::span<const Circle> circles);

}  // namespace circle_voronoi
