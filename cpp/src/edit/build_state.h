// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "circle_voronoi/diagram.h"
#include "circle_voronoi/editor.h"
#include "circle_voronoi/error.h"
#include "edit_state.h"

namespace circle_voronoi {

/// Makes the state of an editor with these circles. Their ids must increase, and new circles get ids from `nextId` on,
/// or from above the largest id for kNone. Of the options, `weights` and `threads` count.
/// Errors: see `compute`; a hidden circle that no one contains is named by its id.
Result<std::unique_ptr<EditState>> buildState(std::span<const Circle> circles, std::span<const CircleId> ids,
                                              CircleId nextId, const EditorOptions& options);

/// Returns the circles of a vertex, starting with the lowest id.
std::array<int, 3> slotsOfVertex(const EditState& state, int face);

/// Returns the disc of a vertex.
Vertex vertexOfFace(const EditState& state, int face);

}  // namespace circle_voronoi
