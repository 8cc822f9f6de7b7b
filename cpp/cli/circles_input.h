// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "circle_voronoi/diagram.h"
#include "circle_voronoi/io.h"
#include "command_error.h"
#include "progress_line.h"

namespace circle_voronoi::cli {

/// A file of circles and its columns: the options of all commands that read circles.
struct CirclesInput {
  std::string file;
  ReadOptions options = {};

  /// Returns whether radii are additive weights.
  bool weights() const { return options.weights; }
};

enum class Skipping { possible, impossible };

/// Adds the file and its options to a command. `radii` applies to a file without a column of radii. Call `settleInput`
/// before you read the file.
void addCirclesInput(CLI::App& command, CirclesInput& input, const std::string& description,
                     Skipping skipping = Skipping::possible, Radii radii = Radii::needed);

/// Adds `--crs` to a command.
void addCrsOption(CLI::App& command, CirclesInput& input);

/// Adds `--metric` to a command.
void addMetricOption(CLI::App& command, std::string& metric);
/// Returns the metric of a name that `addMetricOption` accepts.
Metric metricNamed(const std::string& name);

/// Chooses the file and the column of the weights: the word after --weights is the file if there is no other. Throws
/// CommandError if there is no file, or if options contradict each other.
void settleInput(const CLI::App& command, CirclesInput& input);

/// Throws CommandError if an option about columns is given, for a file that holds a diagram.
void refuseColumnOptions(const CLI::App& command, const std::string& name);

/// Reads the circles of a text. Throws CommandError.
CircleFile readInput(const CirclesInput& input, const std::string& text);

/// Reports on standard error the number of skipped rows, if any, and the error of the first.
void noteSkipped(const CircleFile& file, ProgressLine& progress);

/// Prints a hint on standard error, the warning about hidden circles, if it is not empty. `options` are those that may
/// help.
void noteHidden(const std::string& warning, const std::string& options, ProgressLine& progress);

/// Prints a hint on standard error if circles are given in degrees, for a diagram of the plane.
void noteDegrees(const CircleFile& file, ProgressLine& progress);

/// Prints a note on standard error.
void note(const std::string& sentence, ProgressLine& progress);

}  // namespace circle_voronoi::cli
