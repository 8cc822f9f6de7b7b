// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hide.h"

namespace circle_voronoi {

/// Triangulates the centers of visible circles, unless their triangulation is known.
Sites triangulate(Sites sites, Threads threads = Threads());

}  // namespace circle_voronoi
