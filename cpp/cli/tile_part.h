// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "circles_input.h"
#include "output.h"
#include "progress_line.h"

namespace circle_voronoi::cli {

/// The options about the circles outside a tile, as the user gave them; empty if not given.
struct TilePart {
  std::string known;
  std::string core;
  std::optional<double> maxRadius;
  std::string open;  ///< the file for the parts that are not final

  bool isAsked() const { return !known.empty(); }
};

void addTileOptions(CLI::App& command, TilePart& part);

/// Throws CommandError if options are missing or contradict each other. Called before any work.
void check(const TilePart& part, const Output& output);

/// Computes the diagram of a tile and writes its final parts that belong to circles of the core that are not done.
/// Throws CommandError, with the status kNotFinal if circles of the core are left.
void computeTilePart(const TilePart& part, const Output& output, const CirclesInput& input, int threads,
                     ProgressLine& progress);

}  // namespace circle_voronoi::cli
