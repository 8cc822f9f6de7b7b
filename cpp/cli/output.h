// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "circle_voronoi/attributes.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/export.h"
#include "circle_voronoi/periodic_diagram.h"
#include "circle_voronoi/region.h"
#include "files.h"
#include "progress_line.h"
#include "projection.h"

namespace circle_voronoi::cli {

/// The format, the parts and the destination of the output: options that several commands share.
struct Output {
  std::string file = kStandardStream;
  std::string format;           ///< empty until `settle` chooses it
  std::string bounds;           ///< MINX,MINY,MAXX,MAXY; empty for the default
  std::string regionFile;       ///< empty for none
  bool dissolve = false;        ///< whether polygons of the region that overlap are merged
  bool isRegionNeeded = false;  ///< whether the command itself uses the region, whatever the format
  bool isOnSphere = false;      ///< whether the diagram is one on a sphere, whose formats use other options
  double tolerance = 0;         ///< 0: the default
  std::optional<double> maxDistance = {};
  std::optional<int> digits = {};
  std::optional<Region> region = {};          ///< what `settle` reads from the file
  std::optional<Projection> projection = {};  ///< the projection of circles whose centers were longitude and latitude
  CircleAttributes attributes = {};           ///< the attributes of the circles
};

void addOutputFile(CLI::App& command, Output& output);
void addFormatOption(CLI::App& command, Output& output, const std::vector<std::string>& formats);
/// Adds `--region` and `--dissolve`.
void addRegionOptions(CLI::App& command, Output& output, const std::string& description);
/// Adds these options to a command.
void addOutputOptions(CLI::App& command, Output& output);

/// Writes what `writer` writes to the file of the output. Errors call the input `name`. Throws CommandError.
void write(const Output& output, const std::string& name, ProgressLine& progress,
           const std::function<Result<void>(std::ostream&)>& writer);

/// Returns the extension of a file in lower case, without the dot; empty if there is none.
std::string endingOf(const std::string& file);

/// Chooses the format by the extension of the file, or json, if the user has not chosen one, and reads the region.
/// Called before any work. Throws CommandError if no format has this extension, if an option is given that the format
/// does not use, or if the file of the region does not hold one.
void settle(Output& output);

/// Returns the box, the region, the tolerance, the maximum distance and the digits that the user gave. The output must
/// outlive them.
ExportOptions exportOptions(const Output& output);

/// Throws CommandError if `--crs` is given, but the format cannot name a reference system.
void checkCrs(const CLI::App& command, const Output& output);

/// Adds `--project` to a command.
void addProjectOption(CLI::App& command, std::string& name);

/// Projects circles with longitude and latitude, and the box and the region of the output. The output is converted back
/// to degrees. `name` is the name of a projection; if it is empty, the function does nothing. Throws CommandError,
/// which calls the input `input`. Prints a warning on standard error if scales differ much.
void project(const std::string& name, std::vector<Circle>& circles, Output& output, const std::string& input,
             ProgressLine& progress);

/// Restores the projection from the file of a diagram that `compute` has projected, so that cells are written in
/// degrees. Projects the box and the region. Throws CommandError.
void takeRecordedProjection(Output& output, const CircleAttributes& attributes);

/// Writes a diagram. Errors call the input `name`. Throws CommandError if writing fails, or if the format is a drawing
/// and the diagram is not certified.
void writeDiagram(const Output& output, const std::string& name, const Diagram& diagram, ProgressLine& progress);

/// Adds `--lattice` to a command, as text that `readLattice` reads.
void addLatticeOption(CLI::App& command, std::string& lattice);
/// Throws CommandError if a format or an option does not support periodic diagrams. Called before any work.
void checkPeriodicOutput(const Output& output);
/// Writes a periodic diagram. Errors call the input `name`. Throws CommandError if writing fails.
void writePeriodicDiagram(const Output& output, const std::string& name, const PeriodicDiagram& periodic,
                          ProgressLine& progress);

/// Writes circles without a diagram, and their attributes. Prints a warning on standard error if the format cannot
/// store one of the attributes. Errors call the input `name`. Throws CommandError if the format is only for diagrams,
/// or if writing fails.
void writeCircles(const Output& output, const std::string& name, std::span<const Circle> circles,
                  ProgressLine& progress);

}  // namespace circle_voronoi::cli
