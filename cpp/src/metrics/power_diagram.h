// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/options.h"

namespace circle_voronoi {

/// Computes the certified power diagram of valid circles (validate.h), by the options `weights`, `threads` and
/// `progress`. Errors: notCertified.
Result<Diagram> powerDiagram(std::vector<Circle> circles, const Options& options);

}  // namespace circle_voronoi
