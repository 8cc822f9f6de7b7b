// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "circle_voronoi/circle.h"

namespace circle_voronoi {

/// For each circle a visible one that contains it, or kNone: of those that contain it the largest, of equal ones the
/// one with the lowest of `indices`. Of identical circles the one with the lowest index is visible.
std::vector<int> findHiders(std::span<const Circle> circles, std::span<const int> indices);

}  // namespace circle_voronoi
