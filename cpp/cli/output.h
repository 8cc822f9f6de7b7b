// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <span>
#include <string>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/export.h"
#include "files.h"
#include "progress_line.h"

namespace circle_voronoi::cli {

/// What is written, how and where: the options that commands share.
struct Output {
  std::string file = kStandardStream;
  std::string format;    ///< empty until settled: that of the file's name, or else json
  std::string bounds;    ///< MINX,MINY,MAXX,MAXY; empty: the default
  double tolerance = 0;  ///< 0: the default
  std::optional<double> maxDistance = {};
  std::optional<int> digits = {};
};

void addOutputFile(CLI::App& command, Output& output);
/// Adds the options above.
void addOutputOptions(CLI::App& command, Output& output);

/// What the name of a file ends in, in small letters and without the point; empty if in nothing.
std::string endingOf(const std::string& file);

/// Chooses the format if the user has not, before any work is done. Throws Failure if the file's ending is that of no
/// format, or if an option is given that the format does not use.
void settle(Output& output);

/// The box, the tolerance, the maximum distance and the digits that the user gave.
ExportOptions exportOptions(const Output& output);

/// Writes a diagram. `name` is what the input is called. Throws Failure if the format needs a certified
/// diagram and this is not, or if anything could not be written.
void writeDiagram(const Output& output, const std::string& name, const Diagram& diagram, ProgressLine& progress);

/// Writes circles alone. Throws Failure if the format is one of a diagram only, or if anything could not be written.
void writeCircles(const Output& output, std::span<const Circle> circles, ProgressLine& progress);

}  // namespace circle_voronoi::cli
