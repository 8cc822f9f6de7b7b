// SPDX-License-Identifier: GPL-3.0-or-later
#include "triangulate.h"

#include "centers.h"
#include "delaunay.h"

namespace circle_voronoi {

Sites triangulate(Sites sites, Threads threads) {
  if (sites.centers.origin.empty()) sites.centers = delaunay(centersOf(sites.circles), threads).dual;
  return sites;
}

}  // namespace circle_voronoi
