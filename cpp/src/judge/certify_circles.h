// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/certificate.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"

namespace circle_voronoi {

/// Judges a diagram like `certify`, for what does without power diagrams: badOption for Metric::power.
CIRCLE_VORONOI_API Result<Certificate> certifyCircles(const Diagram& diagram);

}  // namespace circle_voronoi
