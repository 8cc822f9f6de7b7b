// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/certify.h"

#include "certify_circles.h"
#include "certify_power.h"

namespace circle_voronoi {

Result<Certificate> certify(const Diagram& diagram) {
  return diagram.metric == Metric::power ? certifyPower(diagram) : certifyCircles(diagram);
}

}  // namespace circle_voronoi
