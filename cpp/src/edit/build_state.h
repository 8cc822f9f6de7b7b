// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"
#include "edit_state.h"

namespace circle_voronoi {

/// The state of an editor with these circles, whose ids increase. Errors are those of `compute`, by index, but for
/// vertices (vertexError).
Result<std::unique_ptr<EditState>> buildState(std::span<const Circle> circles, std::span<const std::int32_t> ids);

/// A circle in the unit of a state; nothing if it is too large there, or would be rounded.
std::optional<Circle> scaledExactly(const Circle& circle, double unit);

/// Gives a state that has no changes to keep a larger unit. Its signs are proven in any unit, so that nothing is judged
/// again. Returns false, and changes nothing, if the unit would round a circle.
bool rescale(EditState& state, double unit);

/// Rescales a state so that these circles, which are larger than it can hold, have room. Returns whether it did.
bool makeRoom(EditState& state, std::span<const Circle> circles);

/// The circles of a vertex, the one with the least id first, so that its disc has the same bits however it was found.
std::array<int, 3> slotsOfVertex(const EditState& state, int face);

/// The disc of a vertex in the units of the input; nothing if it is beyond the doubles.
std::optional<Vertex> vertexOfFace(const EditState& state, int face);

/// Returns the error of the first vertex that is beyond the doubles, if there is one.
std::optional<Error> vertexError(const EditState& state);

}  // namespace circle_voronoi
