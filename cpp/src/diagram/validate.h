// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/metric.h"
#include "rounded.h"

namespace circle_voronoi {

/// The reason why a circle is invalid: a code, and the rest of a sentence that begins with the name of the circle.
struct CircleError {
  ErrorCode code;
  std::string what;
};

/// Returns the error of a circle, if any: nonFinite, negativeRadius unless radii are weights, coordinateTooLarge. The
/// weights of a power diagram are areas: they may be as large as the square of a coordinate. Exported like `validate`.
CIRCLE_VORONOI_API std::optional<CircleError> errorOf(const Circle& circle, bool weights,
                                                      Metric metric = Metric::circles);

/// Returns the error for an input whose largest number is not 0 and is below kSmallestInput: coordinateTooSmall.
/// `what` begins the sentence, as "The circles".
std::optional<Error> tooSmallError(double largest, const std::string& what);

/// Returns whether the third number of a circle is an area: the weight of a power diagram.
inline bool isArea(bool weights, Metric metric) { return weights && metric == Metric::power; }

/// Returns a circle rounded (limits.h), without negative zeros: one number, one set of bits.
inline Circle normalized(const Circle& given, bool weights = false, Metric metric = Metric::circles) {
  const Circle c = isArea(weights, metric) ? roundedWithArea(given) : rounded(given);
  return {c.x + 0.0, c.y + 0.0, c.r + 0.0};
}

/// Checks the circles. Returns them normalized. The weights of a power diagram are rounded to multiples of 2^-192.
/// Errors: nonFinite, negativeRadius unless radii are weights (Options::weights), coordinateTooLarge,
/// coordinateTooSmall, tooManyCircles, badArithmetic. Exported because the readers and writers, a library of their own,
/// call it.
CIRCLE_VORONOI_API Result<std::vector<Circle>> validate(std::span<const Circle> circles, bool weights = false,
                                                        Metric metric = Metric::circles);

/// Checks a part of the circles of an input, which may all be small. Errors number the circles from `first`.
CIRCLE_VORONOI_API Result<void> validatePart(std::span<const Circle> circles, bool weights, std::size_t first,
                                             Metric metric = Metric::circles);
/// Returns what `validatePart` has accepted, normalized.
std::vector<Circle> normalized(std::span<const Circle> circles, bool weights = false, Metric metric = Metric::circles);

/// Returns the centers as circles of radius 0.
std::vector<Circle> pointsOf(std::span<const Circle> circles);

}  // namespace circle_voronoi
