// SPDX-License-Identifier: GPL-3.0-or-later
#include "spring_system.h"

// The same bits everywhere: vectors of the processor would add up in another order.
#define EIGEN_DONT_VECTORIZE
#define EIGEN_MPL2_ONLY
#include <Eigen/SparseCholesky>
#include <utility>

#include "disjoint_sets.h"

namespace circle_voronoi {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

/// Numbers the components of a graph by the first of their cells.
std::size_t findComponents(std::span<const Spring> springs, std::vector<std::size_t>& componentOf) {
  DisjointSets sets(componentOf.size());
  for (const Spring& spring : springs) sets.join(spring.left, spring.right);
  const auto first = std::move(sets).representatives();
  std::size_t count = 0;
  for (std::size_t i = 0; i < first.size(); ++i)
    componentOf[i] = at(first[i]) == i ? count++ : componentOf[at(first[i])];
  return count;
}

}  // namespace

struct SpringSystem::Factors {
  Matrix matrix;
  Eigen::SimplicialLDLT<Matrix> cholesky;
};

SpringSystem::SpringSystem(std::size_t cells, std::span<const Spring> springs)
    : springs_(springs), componentOf_(cells), row_(cells, -1), factors_(std::make_unique<Factors>()) {
  components_ = findComponents(springs_, componentOf_);
  int rows = 0;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < cells; ++i) {
    if (componentOf_[i] < seen)
      row_[i] = rows++;
    else
      ++seen;
  }
  factors_->matrix.resize(rows, rows);
}

SpringSystem::~SpringSystem() = default;
SpringSystem::SpringSystem(SpringSystem&&) noexcept = default;
SpringSystem& SpringSystem::operator=(SpringSystem&&) noexcept = default;

std::vector<double> SpringSystem::solve(std::span<const double> stiffness, std::span<const double> forces,
                                        std::span<const double> sizes) {
  Matrix& matrix = factors_->matrix;
  const bool isFirst = matrix.nonZeros() == 0;
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(3 * springs_.size());
  for (std::size_t k = 0; k < springs_.size(); ++k) {
    const int i = row_[static_cast<std::size_t>(springs_[k].left)];
    const int j = row_[static_cast<std::size_t>(springs_[k].right)];
    if (i >= 0) entries.emplace_back(i, i, stiffness[k]);
    if (j >= 0) entries.emplace_back(j, j, stiffness[k]);
    if (i >= 0 && j >= 0) entries.emplace_back(std::max(i, j), std::min(i, j), -stiffness[k]);
  }
  matrix.setFromTriplets(entries.begin(), entries.end());

  std::vector<double> sum(components_, 0);
  std::vector<double> size(components_, 0);
  std::vector<double> count(components_, 0);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    sum[componentOf_[i]] += forces[i];
    size[componentOf_[i]] += sizes[i];
    count[componentOf_[i]] += 1;
  }
  Eigen::VectorXd right(matrix.rows());
  for (std::size_t i = 0; i < forces.size(); ++i) {
    if (row_[i] >= 0) right[row_[i]] = forces[i] - sizes[i] * (sum[componentOf_[i]] / size[componentOf_[i]]);
  }
  auto& cholesky = factors_->cholesky;
  if (isFirst) cholesky.analyzePattern(matrix);
  cholesky.factorize(matrix);
  if (cholesky.info() != Eigen::Success) return {};
  const Eigen::VectorXd solution = cholesky.solve(right);
  if (!solution.allFinite()) return {};

  std::vector<double> x(forces.size(), 0);
  std::vector<double> mean(components_, 0);
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (row_[i] >= 0) x[i] = solution[row_[i]];
    mean[componentOf_[i]] += x[i] / count[componentOf_[i]];
  }
  for (std::size_t i = 0; i < x.size(); ++i) x[i] -= mean[componentOf_[i]];
  return x;
}

}  // namespace circle_voronoi
