// SPDX-License-Identifier: GPL-3.0-or-later
#include "radical_center.h"

#include <cmath>
#include <optional>

#include "relative_circle.h"
#include "vectors.h"
#include "weighted_numbers.h"

namespace circle_voronoi {
namespace {

double rootOf(double power) { return std::copysign(std::sqrt(std::abs(power)), power); }

/// In doubles, relative to the first point, or nothing if cancellation leaves too few digits, as for nearly collinear
/// or nearly equal places.
///
/// The determinant is a multiple of 2^-192 (limits.h), and ku and kv are below 2^195. So the center is below 2^487, and
/// its square does not overflow.
std::optional<Vertex> inDoubles(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c) {
  /// The least share of the largest terms that cancellation leaves.
  constexpr double kCertain = 0x1p-12;
  const Vector u = {b.p.x - a.p.x, b.p.y - a.p.y};
  const Vector v = {c.p.x - a.p.x, c.p.y - a.p.y};
  const auto halfOf = [&](Vector w, const WeightedPoint& other) {
    return (dot(w, w) + ((a.weight.value - other.weight.value) + (a.weight.rest - other.weight.rest))) / 2;
  };
  const double ku = halfOf(u, b);
  const double kv = halfOf(v, c);
  const double determinant = cross(u, v);
  const Vector center = {(ku * v.y - kv * u.y) / determinant, (kv * u.x - ku * v.x) / determinant};
  const double square = dot(center, center);
  const double power = square - a.weight.value - a.weight.rest;
  const auto sizeOf = [](const Vector& w) { return std::abs(w.x) + std::abs(w.y); };
  const double weightOfA = std::abs(a.weight.value);
  const double terms = (dot(u, u) + weightOfA + std::abs(b.weight.value)) * sizeOf(v) +
                       (dot(v, v) + weightOfA + std::abs(c.weight.value)) * sizeOf(u);
  const double products = std::abs(u.x * v.y) + std::abs(u.y * v.x);
  const bool isCertain = std::abs(determinant) > kCertain * products &&
                         std::abs(determinant) * sizeOf(center) > kCertain * terms &&
                         std::abs(power) > kCertain * (square + weightOfA);
  if (!isCertain) return std::nullopt;
  return Vertex{a.p.x + center.x, a.p.y + center.y, rootOf(power)};
}

}  // namespace

Vertex radicalCenter(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c) {
  if (const auto quick = inDoubles(a, b, c)) return *quick;
  const WeightedNumbers numbers({{0, 0}, a.p, b.p, c.p}, {a.weight, b.weight, c.weight});
  const auto u = numbers.between(a.p, b.p);
  const auto v = numbers.between(a.p, c.p);
  const auto origin = numbers.between({0, 0}, a.p);
  const auto weight = numbers.weight(a.weight);
  const auto ku = dotOf(u, u) + weight - numbers.weight(b.weight);
  const auto kv = dotOf(v, v) + weight - numbers.weight(c.weight);
  const auto determinant = crossOf(u, v);
  const auto twice = determinant + determinant;
  // The center as seen from the first point, times twice the determinant.
  const auto x = ku * v.y - kv * u.y;
  const auto y = kv * u.x - ku * v.x;
  const int unit = numbers.exponent();
  const exact::Floating below = exact::floating(twice);
  const auto coordinate = [&](const auto& numerator) { return (exact::floating(numerator) / below).times(unit); };
  const auto power = x * x + y * y - weight * (twice * twice);
  const exact::Floating squared = exact::floating(power.sign() < 0 ? -power : power) / (below * below);
  const double radius = power.sign() == 0 ? 0 : sqrt(squared).times(unit);
  return {coordinate(x + twice * origin.x), coordinate(y + twice * origin.y), power.sign() < 0 ? -radius : radius};
}

}  // namespace circle_voronoi
