// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "cell_measure.h"
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
auto fitShares(const std::vector<Circle>& sites, const std::vector<double>& shares, const Domain& domain, int relax = 0,
               Metric metric = Metric::circles) {
  AreaFitOptions options;
  options.metric = metric;
  options.shares = true;
  options.relax = relax;
  return fitAreas(sites, shares, domain, options);
}

/// Expects that springs are the derivatives of areas by the weight of a chosen circle, which was more and less by a
/// step.
inline void expectDerivatives(std::span<const Spring> springs, std::size_t chosen,
                              const std::vector<double>& areasOfMore, const std::vector<double>& areasOfLess,
                              double step) {
  std::vector<double> expected(areasOfMore.size(), 0);
  for (const Spring& spring : springs) {
    const auto i = static_cast<std::size_t>(spring.left);
    const auto j = static_cast<std::size_t>(spring.right);
    EXPECT_NE(i, j);
    if (i != chosen && j != chosen) continue;
    expected[chosen] += spring.stiffness;
    expected[i == chosen ? j : i] -= spring.stiffness;
  }
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR((areasOfMore[i] - areasOfLess[i]) / (2 * step), expected[i], 1e-4 * (1 + std::abs(expected[i])))
        << "cell " << i;
  }
}

}  // namespace circle_voronoi::test
