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

/// A variant of all families that makes them harder. It has exactly `count` circles.
struct Variant {
  std::string_view name;  ///< the suffix of the family's name; empty for the family itself
  std::vector<Circle> (*make)(Family family, std::size_t count, std::uint64_t seed);
};

/// Returns the variants: unchanged; with one point as far away as a sentinel value; with a quarter of duplicates; in
/// two clusters, a thousand times their size apart.
std::span<const Variant> variants();

}  // namespace circle_voronoi
