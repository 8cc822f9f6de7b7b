// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "circle_voronoi/point.h"
#include "circle_voronoi/sphere.h"
#include "elementary.h"
#include "two_part.h"
#include "vectors.h"

namespace circle_voronoi::sphere {

// Places are seen from one another along the ground, in the directions east (x) and north (y). All differences come
// from differences of degrees, so that they have all their digits however near the places are.

/// The length up to which distances in a diagram are the same: it is right for caps that differ by its rounding.
inline double toleranceOf(const SphereDiagram& diagram) {
  return std::max(2 * diagram.rounding, 1e-14 * diagram.radius);
}

/// A place on the sphere.
struct Place {
  double longitude = 0;  ///< from -180 to before 180; 0 at a pole
  double latitude = 0;
  SineCosine ofLatitude;
};

/// Returns a longitude from -180 to before 180, exactly.
inline double wrapped(double longitude) {
  if (longitude >= -180 && longitude < 180) return longitude + 0.0;
  const double rest = std::remainder(longitude, 360.0) + 0.0;  // exact on every platform
  return rest == 180 ? -180 : rest;
}

inline Place placeAt(double longitude, double latitude) {
  const bool isPole = std::abs(latitude) == 90;
  return {isPole ? 0 : wrapped(longitude), latitude, sineCosineOfDegrees(latitude)};
}

/// Another place at the angle t along the ground: its vector, of length sin t, and the square of sin(t / 2).
struct View {
  Vector vector;
  double squaredHalf = 0;

  [[nodiscard]] double angle() const { return angleOf(length(vector), 1 - 2 * squaredHalf); }
};

/// The sines and cosines of half the differences of two places.
struct HalfDifferences {
  SineCosine latitude;
  SineCosine longitude;
};

inline HalfDifferences halfDifferences(const Place& from, const Place& to) {
  TwoPart turn = sum(to.longitude, -from.longitude);
  if (turn.value > 180) turn.value -= 360;  // exact
  if (turn.value < -180) turn.value += 360;
  const TwoPart up = sum(to.latitude, -from.latitude);
  return {sineCosineOfDegrees((up.value + up.rest) / 2), sineCosineOfDegrees((turn.value + turn.rest) / 2)};
}

/// Returns the square of sin(t / 2).
inline double squaredHalf(const Place& from, const Place& to, const HalfDifferences& half) {
  return half.latitude.sine * half.latitude.sine +
         from.ofLatitude.cosine * to.ofLatitude.cosine * half.longitude.sine * half.longitude.sine;
}

inline Vector vectorOf(const Place& from, const Place& to, const HalfDifferences& half) {
  const double across = 2 * to.ofLatitude.cosine * half.longitude.sine;
  return {across * half.longitude.cosine,
          2 * half.latitude.sine * half.latitude.cosine + from.ofLatitude.sine * across * half.longitude.sine};
}

inline View viewOf(const Place& from, const Place& to) {
  const HalfDifferences half = halfDifferences(from, to);
  return {vectorOf(from, to, half), squaredHalf(from, to, half)};
}

/// Returns the place at an angle from another one in a direction (a unit vector).
inline Point pointAt(const Place& from, Vector direction, SineCosine angle) {
  const double up = angle.cosine * from.ofLatitude.sine + angle.sine * direction.y * from.ofLatitude.cosine;
  const double along = angle.cosine * from.ofLatitude.cosine - angle.sine * direction.y * from.ofLatitude.sine;
  const double across = angle.sine * direction.x;
  const double latitude = angleOf(up, std::sqrt(along * along + across * across)) / kDegree;
  return {wrapped(from.longitude + angleOf(across, along) / kDegree), std::clamp(latitude, -90.0, 90.0)};
}

/// The border of a cap toward another one, as seen from its center: where the bearing differs by phi from that of the
/// other cap, the cotangent of the border's angle is amplitude cos(phi) + offset. This is where the two are equally
/// far.
///
/// In the plane of the stereographic projection from the center, the other cap is a circle with its center at the
/// distance `amplitude` and the radius `offset`.
struct Border {
  Vector vector;  ///< toward the other cap, of length `amplitude`
  double offset = 0;
  double height = 0;  ///< cos(difference of the radii) - cos(angle between the centers), positive

  [[nodiscard]] double cotangentToward(Vector direction) const { return dot(vector, direction) + offset; }
};

/// The sine and the cosine of half the difference of two radii, the other one minus the own.
using HalfGrowth = SineCosine;

/// Returns twice the difference of the squares of the half angle and the half growth. It stays above rounding, also for
/// caps of which one nearly hides the other.
inline double heightOf(double half, const HalfGrowth& growth) {
  return 2 * std::max(half - growth.sine * growth.sine, std::max(0x1p-54 * half, 0x1p-300));
}

inline Border borderOf(Vector vector, double height, const HalfGrowth& growth) {
  return {{vector.x / height, vector.y / height}, 2 * growth.sine * growth.cosine / height, height};
}

/// The angle of a cotangent, from 0 to pi.
inline SineCosine arcOf(double cotangent) {
  const double size = std::sqrt(1 + cotangent * cotangent);
  return {1 / size, cotangent / size};
}

/// The place that touches three caps, as seen from one of them.
struct Touch {
  std::size_t from = 0;  ///< which of the three
  Vector direction;      ///< a unit vector
  double cotangent = 0;  ///< of the angle from the center
};

/// The caps of a diagram as places, with radii as angles.
class Places {
 public:
  /// Makes the place of a cap whenever it is asked for: for a few caps.
  static Places ofFew(const SphereDiagram& diagram) { return Places(diagram, 0); }

  explicit Places(const SphereDiagram& diagram) : Places(diagram, diagram.caps.size()) {
    for (const Cap& cap : diagram.caps) places_.push_back(placeAt(cap.longitude, cap.latitude));
  }

  Place operator[](CircleIndex cap) const {
    const auto i = static_cast<std::size_t>(cap);
    return places_.empty() ? placeAt(diagram_.caps[i].longitude, diagram_.caps[i].latitude) : places_[i];
  }

  /// Returns by how much the radius of one cap exceeds that of another, as an angle.
  double growth(CircleIndex from, CircleIndex to) const {
    return (diagram_.caps[static_cast<std::size_t>(to)].r - diagram_.caps[static_cast<std::size_t>(from)].r) /
           diagram_.radius;
  }
  HalfGrowth halfGrowth(CircleIndex from, CircleIndex to) const {
    const double angle = growth(from, to);
    return angle == 0 ? HalfGrowth{} : sineCosine(angle / 2);
  }

  /// Returns the border of a cap toward another one.
  Border border(CircleIndex from, CircleIndex to) const {
    const View view = viewOf((*this)[from], (*this)[to]);
    const HalfGrowth growth = halfGrowth(from, to);
    return borderOf(view.vector, heightOf(view.squaredHalf, growth), growth);
  }

  /// Returns the place that touches three caps, counter-clockwise in this order. The result has the same bits whichever
  /// of them comes first.
  Touch touch(const std::array<CircleIndex, 3>& caps) const;

  /// Returns the place that touches three caps as seen from the first.
  static Touch touchFrom(const Border& second, const Border& third, double oppositeHeight);

 private:
  Places(const SphereDiagram& diagram, std::size_t count) : diagram_(diagram) { places_.reserve(count); }

  const SphereDiagram& diagram_;
  std::vector<Place> places_;
};

}  // namespace circle_voronoi::sphere
