// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"

namespace circle_voronoi {

/// Computes the diagram of circles again after they have changed a little, by flips from the diagram `before`, which
/// has no hidden circles. The result is certified. It is the diagram that `compute` returns, except that its vertices,
/// edges and sides may have other numbers. Returns nothing if flips do not lead to it, as for circles that are hidden
/// now.
///
/// Exported because the library for fits calls it.
CIRCLE_VORONOI_API std::optional<Diagram> recompute(const Diagram& before, std::span<const Circle> circles);

}  // namespace circle_voronoi
