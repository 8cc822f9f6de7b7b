// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

#include "option_flag.h"

namespace circle_voronoi::cli {

/// Adds the option for circles whose radii are additive weights.
inline void addWeightsOption(CLI::App& command, bool& weights) {
  command.add_flag(flagOf(&Options::weights), weights, "Radii are additive weights and may be negative");
}

}  // namespace circle_voronoi::cli
