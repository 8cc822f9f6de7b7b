// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "circle_voronoi/sphere.h"

namespace circle_voronoi::test {

/// Caps with the options that they need.
struct CapInput {
  std::string name;
  std::vector<Cap> caps;
  SphereOptions options;
};

/// Random caps of many kinds: on the whole sphere or in a few millimeters, points or nearly half of the sphere, nested,
/// duplicate, antipodal, and on grids of degrees.
CapInput randomCaps(std::uint64_t seed);

/// The errors of a diagram, found with 50 digits, in units of the sphere's radius.
struct SphereErrors {
  /// The largest length by which a cap reaches into the disc of a vertex, beyond what the rounding of the diagram
  /// allows.
  double reach = 0;
  /// The largest length by which the disc of a vertex fails to touch one of its caps, divided by the size of the disc
  /// and its caps.
  double touch = 0;
  /// The largest error of a vertex's distance, divided by that size, and by the magnification of errors where the
  /// vertex depends on the last bits of its caps.
  double distance = 0;
  std::string message;  ///< about the worst vertex
};

SphereErrors errorsOf(const SphereDiagram& diagram);

/// The distance of a place from a cap, with 50 digits before it is rounded.
double exactDistance(const SphereDiagram& diagram, CircleIndex cap, double longitude, double latitude);

/// C++ that makes the caps, to the bit.
std::string describe(const std::vector<Cap>& caps);

}  // namespace circle_voronoi::test
