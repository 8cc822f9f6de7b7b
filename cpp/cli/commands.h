// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace circle_voronoi::cli {

// Each adds one command to the program. A command runs while the command line is parsed, and may throw CommandError.

void addCertifyCommand(CLI::App& program);
void addComputeCommand(CLI::App& program);
void addConvertCommand(CLI::App& program);
void addEditCommand(CLI::App& program);
void addFindCommand(CLI::App& program);
void addFitCommand(CLI::App& program);
void addGenerateCommand(CLI::App& program);
void addTileCommand(CLI::App& program);
void addTreemapCommand(CLI::App& program);

}  // namespace circle_voronoi::cli
