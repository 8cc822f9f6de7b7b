// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace circle_voronoi {

/// The point at infinity as a corner of a face.
inline constexpr int kPointAtInfinity = -1;

}  // namespace circle_voronoi
