// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "circle_voronoi/abi.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// "None" in place of an index: the unbounded end of an edge, no circle, no vertex.
inline constexpr std::int32_t kNone = -1;

}  // namespace circle_voronoi
