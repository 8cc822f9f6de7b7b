// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"

namespace circle_voronoi {

/// Computes the certified power diagram of valid circles (validate.h), whose radii may be the weights themselves.
/// Errors: notCertified.
Result<Diagram> powerDiagram(std::vector<Circle> circles, bool weights);

}  // namespace circle_voronoi
