// SPDX-License-Identifier: GPL-3.0-or-later
#include "validate.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "arithmetic.h"
#include "circle_voronoi/limits.h"
#include "estimate.h"

namespace circle_voronoi {
namespace {

double sizeOf(const Circle& c) { return std::max({std::abs(c.x), std::abs(c.y), std::abs(c.r)}); }

}  // namespace

std::optional<Objection> objectionTo(const Circle& c, bool weights) {
  if (!std::isfinite(c.x)) return Objection{ErrorCode::nonFinite, "has an x that is not a finite number."};
  if (!std::isfinite(c.y)) return Objection{ErrorCode::nonFinite, "has a y that is not a finite number."};
  if (!std::isfinite(c.r)) return Objection{ErrorCode::nonFinite, "has a radius that is not a finite number."};
  if (c.r < 0 && !weights) return Objection{ErrorCode::negativeRadius, "has a negative radius."};
  if (sizeOf(c) <= kCoordinateLimit) return std::nullopt;
  return Objection{ErrorCode::coordinateTooLarge, "has a coordinate or a radius beyond 1e150."};
}

Result<ScaledCircles> validate(std::span<const Circle> circles, bool weights, std::size_t first) {
  if (circles.size() > kMaxCircles) {
    return Error{ErrorCode::tooManyCircles, -1,
                 "There are " + std::to_string(circles.size()) + " circles; at most " + std::to_string(kMaxCircles) +
                     " are possible."};
  }
  if (!isArithmeticStandard()) {
    return Error{ErrorCode::badArithmetic, -1,
                 "Floating-point numbers are not rounded to nearest or tiny ones are taken for zero, as in a program "
                 "that is linked with -ffast-math."};
  }
  double largest = 0;
  for (std::size_t i = 0; i < circles.size(); ++i) {
    if (const auto objection = objectionTo(circles[i], weights)) {
      const std::size_t circle = first + i;
      return Error{objection->code, static_cast<std::int64_t>(circle),
                   "Circle " + std::to_string(circle) + " " + objection->what};
    }
    largest = std::max(largest, sizeOf(circles[i]));
  }

  int exponent = 0;
  std::frexp(largest, &exponent);  // exact, as is ldexp: neither rounds
  const int scaling = largest == 0 ? 0 : std::min(kScaledExponent - exponent, kLargestScaling);
  const double factor = std::ldexp(1.0, scaling);
  ScaledCircles scaled;
  scaled.unit = std::ldexp(1.0, -scaling);
  scaled.circles.reserve(circles.size());
  // Adding zero turns -0 into +0: one number, one set of bits.
  for (const Circle& c : circles)
    scaled.circles.push_back({c.x * factor + 0.0, c.y * factor + 0.0, c.r * factor + 0.0});
  return scaled;
}

Vertex discOfInput(const Vertex& disc, double unit) {
  const Vertex result = {disc.x * unit, disc.y * unit, disc.r * unit};
  if (std::isfinite(result.x) && std::isfinite(result.y) && std::isfinite(result.r)) return result;
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  return {kNaN, kNaN, kNaN};
}

std::vector<Circle> pointsOf(std::span<const Circle> circles) {
  std::vector<Circle> points(circles.begin(), circles.end());
  for (Circle& c : points) c.r = 0;
  return points;
}

}  // namespace circle_voronoi
