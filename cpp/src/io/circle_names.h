// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "circle_voronoi/attributes.h"

namespace circle_voronoi {

/// Returns the name of each circle from the first usual property that it has, such as name or label; an empty text if
/// it has none. The list is empty if there are no attributes.
std::vector<std::string> namesIn(const CircleAttributes* attributes);

}  // namespace circle_voronoi
