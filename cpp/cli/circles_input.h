// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "circle_voronoi/diagram.h"
#include "circle_voronoi/io.h"
#include "failure.h"
#include "progress_line.h"

namespace circle_voronoi::cli {

/// A file of circles, and which of its columns these are: the options that all commands share which read circles.
struct CirclesInput {
  std::string file;
  ReadOptions options = {};

  /// Returns whether radii are additive weights.
  bool weights() const { return options.weights; }
};

enum class Skipping { possible, impossible };

/// Adds the file and its options to a command. `radii`: of a file without a column for them. `settleInput` has to be
/// called before the file is read.
void addCirclesInput(CLI::App& command, CirclesInput& input, const std::string& description,
                     Skipping skipping = Skipping::possible, Radii radii = Radii::needed);

/// Chooses the file and the column of the weights: the word after --weights is the file if there is no other. Throws
/// Failure if there is no file, or if options contradict each other.
void settleInput(const CLI::App& command, CirclesInput& input);

/// Throws Failure if an option about columns is given, for a file that holds a diagram.
void refuseColumnOptions(const CLI::App& command, const std::string& name);

/// Reads the circles of a text. Throws Failure.
CircleFile readInput(const CirclesInput& input, const std::string& text);

/// Returns the failure of a reader, which names options as on the command line.
Failure inputFailure(Error error);

/// Says on standard error how many rows were skipped, if any, and why the first one.
void noteSkipped(const CircleFile& file, ProgressLine& progress);

/// Says on standard error if more than a quarter of the circles of a file are hidden, and why that may be.
void noteHidden(const Diagram& diagram, ProgressLine& progress);

/// Writes a sentence to standard error that is no error.
void note(const std::string& sentence, ProgressLine& progress);

}  // namespace circle_voronoi::cli
