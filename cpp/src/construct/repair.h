// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "circle_voronoi/circle.h"
#include "dual.h"
#include "predicates.h"

namespace circle_voronoi {

/// A certified dual of a few circles, none of which hides another, or nothing.
using LocalSolver = std::function<std::optional<Dual>(std::span<const Circle>)>;

/// Repairs a dual where it is visibly wrong: a face without a disc, or an edge whose ends are out of order. The faces
/// within `reach` steps of such a place form a patch; the circles around the patch get a diagram of their own from
/// `solve`, and what it has inside the patch's boundary replaces the patch, if the boundary fits. The rest of the dual
/// stays as it is, so the cost depends on the patches alone. The result is to be judged again.
///
/// Returns the number of patches replaced.
std::int64_t repair(std::span<const Circle> circles, Dual& dual, Predicates& predicates, int reach,
                    const LocalSolver& solve);

}  // namespace circle_voronoi
