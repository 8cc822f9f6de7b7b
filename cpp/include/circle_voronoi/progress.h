// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string_view>

#include "circle_voronoi/abi.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// A stage of `compute`, named as its time in Seconds.
enum class Stage { hide, sample, pair, touch, flip, repair, certify };

/// The name of a stage, as in JSON and JavaScript: that of the enumerator.
std::string_view stageName(Stage stage);

/// Told when a stage begins (0) and, in those of the touching disc method (sample, pair, touch), which part of it is
/// done, up to 1. Which stages there are, and how often, is up to the method and the input. What it throws passes
/// through `compute`, which is how to cancel one.
using Progress = std::function<void(Stage stage, double done)>;

}  // namespace circle_voronoi
