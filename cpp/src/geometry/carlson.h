// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/abi.h"

namespace circle_voronoi {

/// R_F(x, y, z) and R_D(x, y, z).
struct Carlson {
  double first;
  double second;
};

/// Carlson's elliptic integrals to rounding, of the squares of three numbers above 0, by his duplication theorem (DLMF
/// 19.36): each step quarters the differences of the arguments from their mean, and a series in the last differences
/// gives the rest. Exported because fits use it.
CIRCLE_VORONOI_API Carlson carlson(double rootX, double rootY, double rootZ);

}  // namespace circle_voronoi
