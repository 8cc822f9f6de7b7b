// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"

namespace circle_voronoi::test {

/// The first thing in which a diagram is no diagram at all, whatever its circles: an index out of range, a vertex
/// without three edges in order, a hull that does not follow the unbounded ends, a wrong number of parts. Empty:
/// nothing.
std::string structureProblem(const Diagram& diagram, std::size_t circleCount);

/// A diagram with other indices of circles, its lists in the same order.
Diagram renamed(Diagram diagram, const std::vector<std::int32_t>& names);

/// The first thing in which two diagrams of circles differ: the circles of the vertices with their orientation, the
/// unbounded ends, or the hidden circles. Empty: nothing.
std::string difference(const Diagram& actual, const Diagram& expected);

/// The same after merging: vertices joined by edges of length zero, but for rounding, are one vertex, and those too far
/// away to matter are infinity. For circles in degenerate position, where the trivalent vertices may be chosen freely.
std::string differenceAfterMerging(const Diagram& actual, const Diagram& expected, std::span<const Circle> circles);

/// The problem of a diagram: its structure, or its difference from the exact one.
std::string problemInGeneralPosition(const Diagram& diagram, const Diagram& exact, std::span<const Circle> circles);
std::string problemInDegeneratePosition(const Diagram& diagram, const Diagram& exact, std::span<const Circle> circles);

}  // namespace circle_voronoi::test
