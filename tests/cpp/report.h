// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "circle_voronoi/circle.h"

namespace circle_voronoi::test {

/// The environment variable CIRCLE_VORONOI_SEED, or `otherwise`; printed, so that a failure can be repeated.
std::uint64_t seedOr(std::uint64_t otherwise);

/// Circles to the bit, as C++ that makes them.
std::string describe(std::span<const Circle> circles);

}  // namespace circle_voronoi::test
