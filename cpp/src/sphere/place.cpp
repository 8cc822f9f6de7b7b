// SPDX-License-Identifier: GPL-3.0-or-later
#include "place.h"

#include <tuple>

namespace circle_voronoi::sphere {

// Seen from the first cap, the other two are circles of the plane, and the disc that touches all three is a half-plane.
// The place lies in the direction normal to their common tangent line. The square of the tangent's length between them
// is 2 h / (h' h''), where h is the height between the two and h', h'' are those from the first cap: it does not
// cancel.

Touch Places::touchFrom(const Border& second, const Border& third, double oppositeHeight) {
  const Vector step = {third.vector.x - second.vector.x, third.vector.y - second.vector.y};
  const double growth = third.offset - second.offset;
  const double tangent = std::sqrt(2 * oppositeHeight / (second.height * third.height));
  const Vector normal = {step.y * tangent - step.x * growth, -(step.x * tangent + step.y * growth)};
  const double size = length(normal);
  const Vector direction = size > 0 ? Vector{normal.x / size, normal.y / size} : Vector{1, 0};
  // The nearer circle has lost fewer digits.
  const bool isSecond = dot(second.vector, second.vector) < dot(third.vector, third.vector);
  return {0, direction, (isSecond ? second : third).cotangentToward(direction)};
}

Touch Places::touch(const std::array<CircleIndex, 3>& caps) const {
  // Entry k is between the caps k + 1 and k + 2.
  std::array<HalfDifferences, 3> differences;
  std::array<HalfGrowth, 3> growths;
  std::array<double, 3> heights{};
  for (std::size_t k = 0; k < 3; ++k) {
    const CircleIndex from = caps[(k + 1) % 3];
    const CircleIndex to = caps[(k + 2) % 3];
    differences[k] = halfDifferences((*this)[from], (*this)[to]);
    growths[k] = halfGrowth(from, to);
    heights[k] = heightOf(squaredHalf((*this)[from], (*this)[to], differences[k]), growths[k]);
  }
  // The two that are farthest apart are seen from the third: then their difference keeps its digits.
  const auto rank = [&](std::size_t k) {
    const Place& place = (*this)[caps[k]];
    return std::tuple(heights[k], place.latitude, place.longitude);
  };
  std::size_t best = 0;
  if (rank(1) > rank(best)) best = 1;
  if (rank(2) > rank(best)) best = 2;
  const std::size_t second = (best + 1) % 3;
  const std::size_t third = (best + 2) % 3;
  // The view of the third from the first is the opposite of entry `second`, which goes from the third to the first.
  HalfDifferences back = differences[second];
  back.latitude.sine = -back.latitude.sine;
  back.longitude.sine = -back.longitude.sine;
  const Place& from = (*this)[caps[best]];
  const Border toSecond =
      borderOf(vectorOf(from, (*this)[caps[second]], differences[third]), heights[third], growths[third]);
  const Border toThird = borderOf(vectorOf(from, (*this)[caps[third]], back), heights[second],
                                  {-growths[second].sine, growths[second].cosine});
  Touch touch = touchFrom(toSecond, toThird, heights[best]);
  touch.from = best;
  return touch;
}

}  // namespace circle_voronoi::sphere
