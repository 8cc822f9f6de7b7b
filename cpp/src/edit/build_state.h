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

/// Makes the state of an editor with these circles. Their ids must increase.
/// Errors: see `compute`, with ids instead of indices, except for vertices (vertexError).
Result<std::unique_ptr<EditState>> buildState(std::span<const Circle> circles, std::span<const CircleId> ids,
                                              bool weights);

/// Returns a circle in the unit of a state. Returns nothing if it is too large there, or would be rounded.
std::optional<Circle> scaledExactly(const Circle& circle, double unit);

/// Gives a state without unkept changes a larger unit. Its signs are proven in any unit, so nothing is judged again.
/// Returns false, and changes nothing, if the unit would round a circle.
bool rescale(EditState& state, double unit);

/// Rescales a state to make room for circles that are larger than it can hold. Returns whether it did.
bool makeRoom(EditState& state, std::span<const Circle> circles);

/// Returns the circles of a vertex, starting with the lowest id, so that its disc has the same bits however it was
/// found.
std::array<int, 3> slotsOfVertex(const EditState& state, int face);

/// Returns the disc of a vertex in the unit of the input; nothing if a number exceeds the largest double.
std::optional<Vertex> vertexOfFace(const EditState& state, int face);

/// Returns the error of the first vertex that exceeds the largest double, if there is one.
std::optional<Error> vertexError(const EditState& state);

}  // namespace circle_voronoi
