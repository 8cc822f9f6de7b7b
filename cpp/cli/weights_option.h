// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace circle_voronoi::cli {

/// Adds the option for circles whose radii are additive weights.
inline void addWeightsOption(CLI::App& command, bool& weights) {
  command.add_flag("--weights", weights, "Radii are additive weights and may be negative");
}

}  // namespace circle_voronoi::cli
