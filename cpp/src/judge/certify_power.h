// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/certificate.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"

namespace circle_voronoi {

/// `certify` for a diagram by Metric::power.
Result<Certificate> certifyPower(const Diagram& diagram);

}  // namespace circle_voronoi
