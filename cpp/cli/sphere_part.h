// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "circle_voronoi/sphere.h"
#include "circles_input.h"
#include "output.h"
#include "progress_line.h"

namespace circle_voronoi::cli {

/// The options about circles on the Earth, as the user gave them.
struct SpherePart {
  bool isAsked = false;
  std::string unit = "km";
};

void addSphereOptions(CLI::App& command, SpherePart& part);

/// Throws CommandError if an option of the command, or a format, has no meaning on a sphere.
void check(const SpherePart& part, const CLI::App& command, const Output& output);

/// Computes the diagram of circles on the Earth. Throws CommandError.
SphereDiagram diagramOnSphere(const SpherePart& part, const CirclesInput& input, const CircleFile& file, int threads,
                              ProgressLine& progress);

/// Computes the diagram of circles whose centers are longitude and latitude, and writes it. Throws CommandError.
void computeOnSphere(const SpherePart& part, const Output& output, const CirclesInput& input, CircleFile file,
                     int threads, ProgressLine& progress);

}  // namespace circle_voronoi::cli
