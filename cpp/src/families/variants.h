// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi_families/families.h"

namespace circle_voronoi {

/// Variants that make circles of any family harder: exactly `count` of them.
struct Variant {
  std::string_view name;  ///< the suffix of the family's name; empty for the family itself
  std::vector<Circle> (*make)(Family family, std::size_t count, std::uint64_t seed);
};

/// The family as it is; with one point as far off as a sentinel value may be; a quarter of it copies; in two clusters,
/// a thousand times farther apart.
std::span<const Variant> variants();

}  // namespace circle_voronoi
