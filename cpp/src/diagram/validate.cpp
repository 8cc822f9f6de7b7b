// SPDX-License-Identifier: GPL-3.0-or-later
#include "validate.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "arithmetic.h"

namespace circle_voronoi {

namespace {

/// The largest weight of a power diagram.
constexpr double kWeightLimit = kCoordinateLimit * kCoordinateLimit;

}  // namespace

std::optional<CircleError> errorOf(const Circle& c, bool weights, Metric metric) {
  const bool hasArea = isArea(weights, metric);
  const std::string size = hasArea ? "weight" : "radius";
  if (!std::isfinite(c.x)) return CircleError{ErrorCode::nonFinite, "has an x that is not a finite number."};
  if (!std::isfinite(c.y)) return CircleError{ErrorCode::nonFinite, "has a y that is not a finite number."};
  if (!std::isfinite(c.r)) return CircleError{ErrorCode::nonFinite, "has a " + size + " that is not a finite number."};
  if (c.r < 0 && !weights) return CircleError{ErrorCode::negativeRadius, "has a negative radius."};
  if (hasArea && std::abs(c.r) > kWeightLimit) {
    return CircleError{ErrorCode::coordinateTooLarge, "has a weight beyond 6.3e57 (2^192)."};
  }
  if (largestNumber({c.x, c.y, hasArea ? 0 : c.r}) <= kCoordinateLimit) return std::nullopt;
  return CircleError{ErrorCode::coordinateTooLarge,
                     std::string("has a coordinate or a radius beyond ") + kCoordinateLimitText + "."};
}

std::optional<Error> tooSmallError(double largest, const std::string& what) {
  if (largest == 0 || largest >= kSmallestInput) return std::nullopt;
  int exponent = 0;
  std::frexp(largest, &exponent);
  // 10^power is at least 2^-exponent, so the product is at least 1/2.
  const int power = (-exponent * 30103 + 99999) / 100000;
  return Error{ErrorCode::coordinateTooSmall, kNone,
               what + " are too small: all numbers are below " + kSmallestInputText + ". Multiply them by 1e" +
                   std::to_string(power) + "."};
}

Result<void> validatePart(std::span<const Circle> circles, bool weights, std::size_t first, Metric metric) {
  if (circles.size() > kMaxCircles) {
    return Error{ErrorCode::tooManyCircles, kNone,
                 "There are " + std::to_string(circles.size()) + " circles; at most " + std::to_string(kMaxCircles) +
                     " are possible."};
  }
  if (!isArithmeticStandard()) {
    return Error{ErrorCode::badArithmetic, kNone,
                 "Floating-point numbers are not rounded to nearest or tiny ones are taken for zero, as in a program "
                 "that is linked with -ffast-math."};
  }
  for (std::size_t i = 0; i < circles.size(); ++i) {
    if (const auto error = errorOf(circles[i], weights, metric)) {
      const std::size_t circle = first + i;
      return Error{error->code, static_cast<std::int64_t>(circle),
                   "Circle " + std::to_string(circle) + " " + error->what};
    }
  }
  return {};
}

Result<std::vector<Circle>> validate(std::span<const Circle> circles, bool weights, Metric metric) {
  if (const auto valid = validatePart(circles, weights, 0, metric); !valid) return valid.error();
  double largest = 0;
  for (const Circle& c : circles) {
    const double size = isArea(weights, metric) ? std::sqrt(std::abs(c.r)) : c.r;
    largest = std::max(largest, largestNumber({c.x, c.y, size}));
  }
  if (auto error = tooSmallError(largest, "The circles")) return *std::move(error);
  return normalized(circles, weights, metric);
}

std::vector<Circle> normalized(std::span<const Circle> circles, bool weights, Metric metric) {
  std::vector<Circle> result;
  result.reserve(circles.size());
  for (const Circle& c : circles) result.push_back(normalized(c, weights, metric));
  return result;
}

std::vector<Circle> pointsOf(std::span<const Circle> circles) {
  std::vector<Circle> points(circles.begin(), circles.end());
  for (Circle& c : points) c.r = 0;
  return points;
}

}  // namespace circle_voronoi
