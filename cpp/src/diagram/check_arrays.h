// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"

namespace circle_voronoi {

/// Checks in linear time that a diagram can be walked: each index has its item, each side belongs to the one cycle of
/// sides around its cell and ends where the next one begins, and all numbers are finite. Other arrays would lead a walk
/// outside the arrays, or around without an end. Whether the diagram is right, only `certify` tells.
///
/// Errors: badInput; for circles see `validate`. Exported because the writers, a library of their own, call it.
CIRCLE_VORONOI_API Result<void> checkArrays(const Diagram& diagram);
/// Checks the arrays of some cells alone, in time for their sides. The circles are in range.
Result<void> checkArrays(const Diagram& diagram, std::span<const CircleIndex> circles);

}  // namespace circle_voronoi
