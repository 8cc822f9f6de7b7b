// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "circle_voronoi/diagram.h"
#include "circle_voronoi/options.h"
#include "journal.h"

namespace circle_voronoi {

/// Returns the number of samples that the touching disc method takes.
int sampleCountOf(const Options& options);

/// Runs the touching disc method on the candidates of `options`, and judges the diagram of `circles`, the input. With
/// `options.resample`, tries again with more samples around the flaw. `valid` are the circles as validate returns them.
/// Events go to the observer of `options`. Throws the error of `refusalOfHidden`.
Diagram touchingDiscDiagram(std::span<const Circle> circles, std::vector<Circle> valid, const Options& options,
                            Journal& journal);

}  // namespace circle_voronoi
