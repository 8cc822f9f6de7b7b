// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hide.h"

namespace circle_voronoi {

/// Triangulates the centers of visible circles, unless that is done or their diagram is there.
Sites triangulate(Sites sites, Threads threads = Threads());

}  // namespace circle_voronoi
