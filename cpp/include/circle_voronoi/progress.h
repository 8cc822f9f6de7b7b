// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string_view>

#include "circle_voronoi/abi.h"

namespace circle_voronoi {

/// A stage of `compute`, named like its time in Seconds.
enum class Stage { order, triangulate, sample, pair, touch, flip, repair, certify, assemble };

/// Returns the name of a stage, as in the enumeration, in JSON and in JavaScript.
[[nodiscard]] CIRCLE_VORONOI_API std::string_view stageName(Stage stage);

/// A callback that `compute` calls when a stage begins, with `done` = 0. The stages of the touching disc method
/// (sample, pair, touch) also call it with the part of the stage that is done, up to 1. The method and the input
/// determine which stages run, and how often. To cancel a computation, throw: the exception passes through `compute`.
/// The callback may call any function of the library.
using Progress = std::function<void(Stage stage, double done)>;

}  // namespace circle_voronoi
