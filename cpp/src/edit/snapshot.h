// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/diagram.h"
#include "circle_voronoi/editor.h"
#include "circle_voronoi/error.h"
#include "edit_state.h"

namespace circle_voronoi {

/// Returns the diagram of a state, with the circles in the order of their ids.
Result<Diagram> snapshotOf(const EditState& state);

/// Returns the ids and numbers that the indices in the snapshot of a state stand for.
SnapshotNumbers numbersOf(const EditState& state);

}  // namespace circle_voronoi
