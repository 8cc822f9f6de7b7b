// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/convex_polygon.h"

namespace circle_voronoi::test {

/// The region of a box that is one.
inline ConvexPolygon regionOf(const Box& box) { return ConvexPolygon::from(box).value(); }

}  // namespace circle_voronoi::test
