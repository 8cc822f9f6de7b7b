// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "circle_voronoi/circle.h"
#include "dual.h"
#include "face_discs.h"

namespace circle_voronoi {

/// A certified dual of a few circles, none of which hides another, or nothing.
using LocalSolver = std::function<std::optional<Dual>(std::span<const Circle>)>;

/// Repairs a dual where it is visibly wrong. The faces within `reach` steps of a wrong face form a patch. `solve`
/// computes a dual of the circles around the patch. Its part inside the patch's boundary replaces the patch if the
/// boundary fits. The rest of the dual is neither changed nor read, so the cost depends on the patches alone. The
/// result is to be judged again.
///
/// `discs` are all the discs of `dual` and `wrong` all its wrong faces (wrong_faces.h), before and after.
/// Returns the number of patches replaced.
std::int64_t repair(Dual& dual, FaceDiscs& discs, std::vector<int>& wrong, int reach, const LocalSolver& solve);

}  // namespace circle_voronoi
