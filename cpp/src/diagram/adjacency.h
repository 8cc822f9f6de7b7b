// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "circle_voronoi/diagram.h"

namespace circle_voronoi {

/// Returns the links of a diagram. Returns nothing if its vertices, edges and hull do not fit together.
std::optional<Links> linksOf(const Diagram& diagram);

}  // namespace circle_voronoi
