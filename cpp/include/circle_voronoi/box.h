// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/abi.h"

namespace circle_voronoi {

/// An axis-parallel rectangle with minX < maxX and minY < maxY.
struct Box {
  double minX = 0;
  double minY = 0;
  double maxX = 1;
  double maxY = 1;
};

}  // namespace circle_voronoi
