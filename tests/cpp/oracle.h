// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"

namespace circle_voronoi::oracle {

/// The Voronoi diagram by CGAL's Apollonius graph with exact decisions, without coordinates, hull and stats, and
/// without the hiders of hidden circles.
///
/// This library is a world of its own: it is compiled with GMP and directed rounding, the core without, so nothing of
/// CGAL may be visible outside.
[[gnu::visibility("default")]] Diagram exactDiagram(std::span<const Circle> circles);

}  // namespace circle_voronoi::oracle
