// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "cell_measure.h"

namespace circle_voronoi {

/// The linear system L x = f of springs that pull cells together, where L is the weighted graph Laplacian. The forces
/// `f` sum to zero in each component of the graph, and x has the mean 0 there.
///
/// A sparse Cholesky decomposition solves it. Conjugate gradients are slower at every size, with an incomplete
/// decomposition too: springs of very different stiffness take them many iterations.
class SpringSystem {
 public:
  SpringSystem(std::size_t cells, std::span<const Spring> springs);
  ~SpringSystem();
  SpringSystem(SpringSystem&&) noexcept;
  SpringSystem& operator=(SpringSystem&&) noexcept;

  /// Returns x for springs of other stiffness in the same places. The sum of a component's forces is first subtracted
  /// from its cells in proportion to their sizes, which are positive: rounding of a large area would be more than a
  /// small area is. Returns nothing if rounding leaves no solution.
  std::vector<double> solve(std::span<const double> stiffness, std::span<const double> forces,
                            std::span<const double> sizes);

  /// For each cell the number of its component, counted from 0.
  [[nodiscard]] const std::vector<std::size_t>& componentOf() const { return componentOf_; }
  [[nodiscard]] std::size_t components() const { return components_; }

 private:
  struct Factors;

  std::span<const Spring> springs_;
  std::vector<std::size_t> componentOf_;
  std::vector<int> row_;  ///< the index of each cell in the system; -1 for the fixed cell of each component
  std::size_t components_ = 0;
  std::unique_ptr<Factors> factors_;
};

}  // namespace circle_voronoi
