// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "arithmetic.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/point.h"

namespace circle_voronoi {

inline double cross(Vector u, Vector v) { return u.x * v.y - u.y * v.x; }
inline double dot(Vector u, Vector v) { return u.x * v.x + u.y * v.y; }
inline double length(Vector v) { return std::sqrt(dot(v, v)); }

/// From the centre of one circle to the centre of another.
inline Vector between(const Circle& from, const Circle& to) { return {to.x - from.x, to.y - from.y}; }

}  // namespace circle_voronoi
