// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi_families/families.h"
#include "dual.h"

namespace circle_voronoi::test {

// Right duals of few circles, for tests of the stages that change a dual or judge it.

/// Families with many kinds of neighbors.
inline constexpr std::array kFamilies = {Family::uniform,      Family::logUniform, Family::oneHuge,   Family::extreme,
                                         Family::intersecting, Family::chaos,      Family::ringVaried};

/// Circles of a family as the stages get them: scaled, in spatial order, none hidden.
std::vector<Circle> visibleCircles(Family family, std::size_t count, std::uint64_t seed);

bool isRight(std::span<const Circle> circles, const Dual& dual);

/// The dual of visible circles by the touching disc method on all pairs, and if that is wrong by CGAL's graph.
std::optional<Dual> solve(std::span<const Circle> circles);

}  // namespace circle_voronoi::test
