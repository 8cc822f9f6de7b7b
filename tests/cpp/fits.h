// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "circle_voronoi/fit_areas.h"
#include "random.h"

namespace circle_voronoi::test {

/// Random numbers over some decades.
inline std::vector<double> sharesOver(double decades, std::size_t count, circle_voronoi::Random& random) {
  std::vector<double> shares;
  for (std::size_t i = 0; i < count; ++i) shares.push_back(random.logUniform(0, decades));
  return shares;
}

/// Fits the cells in a region or in the box of a lattice to shares of its area.
template <class Domain>
auto fitShares(const std::vector<Circle>& sites, const std::vector<double>& shares, const Domain& domain,
               int relax = 0) {
  AreaFitOptions options;
  options.shares = true;
  options.relax = relax;
  return fitAreas(sites, shares, domain, options);
}

}  // namespace circle_voronoi::test
