// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"

namespace circle_voronoi {

/// The power diagram, as the dual of CGAL's regular triangulation of the centres with weights r^2: exact for the
/// weights as rounded.
/// Errors: those of `validate`; coordinateTooLarge, if a vertex is beyond the range of numbers.
Result<Diagram> powerDiagram(std::span<const Circle> circles);

}  // namespace circle_voronoi
