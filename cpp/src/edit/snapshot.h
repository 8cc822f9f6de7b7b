// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/diagram.h"
#include "circle_voronoi/editor.h"
#include "circle_voronoi/error.h"
#include "edit_state.h"

namespace circle_voronoi {

/// The diagram of a state, circles in the order of their ids.
Result<Diagram> snapshotOf(const EditState& state);

/// What its indices stand for.
SnapshotNumbers numbersOf(const EditState& state);

}  // namespace circle_voronoi
