// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace circle_voronoi {

inline constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// The point at infinity as a corner of a face.
inline constexpr int kPointAtInfinity = -1;
inline bool isFinite(int corner) { return corner != kPointAtInfinity; }

}  // namespace circle_voronoi
