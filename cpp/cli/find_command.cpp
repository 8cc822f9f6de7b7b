// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "circle_voronoi/cells.h"
#include "circle_voronoi/certify.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/finder.h"
#include "circle_voronoi/io.h"
#include "circle_voronoi/sphere.h"
#include "circles_input.h"
#include "command_error.h"
#include "commands.h"
#include "files.h"
#include "output.h"
#include "progress_line.h"
#include "sphere_part.h"

namespace circle_voronoi::cli {
namespace {

struct FindArguments {
  CirclesInput input;
  std::string at;
  std::string projection;
  std::string metric{nameOf(Options{}.metric)};
  SpherePart sphere;
  Output output;
  std::string progress = "auto";
};

/// Reads a diagram, or computes that of circles. Sets the projection and the attributes of the output.
Diagram diagramOf(const CLI::App& command, FindArguments& arguments, const std::string& text, const std::string& name,
                  ProgressLine& progress) {
  if (holdsDiagram(text)) {
    refuseColumnOptions(command, name);
    for (const char* option : {"--metric", "--project"}) {
      if (command.count(option) == 0) continue;
      throw CommandError{kBadInput, name + ": " + option + " is for circles alone; the file holds a diagram."};
    }
    auto read = readDiagramFile(text, name);
    if (!read) throw CommandError{kBadInput, read.error().message};
    if (read->isPeriodic) throw CommandError{kBadInput, name + ": find takes no diagram of compute --lattice."};
    const auto certificate = certify(read->diagram);
    if (!certificate) throw CommandError{kBadInput, name + ": " + certificate.error().message};
    if (!certificate->certified()) {
      throw CommandError{kFailure, name + ": The diagram is not certified: " + certificate->message};
    }
    arguments.output.attributes = std::move(read->attributes);
    takeRecordedProjection(arguments.output, arguments.output.attributes);
    return std::move(read->diagram);
  }
  CircleFile file = readInput(arguments.input, text);
  if (arguments.projection.empty()) noteDegrees(file, progress);
  noteSkipped(file, progress);
  arguments.output.attributes = std::move(file.attributes);
  project(arguments.projection, file.circles, arguments.output, name, progress);
  Options options;
  options.weights = arguments.input.weights();
  options.metric = metricNamed(arguments.metric);
  progress.show("compute");
  auto diagram = compute(file.circles, options);
  if (!diagram) fail(diagram.error(), name + ": ");
  return std::move(diagram).value();
}

std::vector<Found> foundIn(const Diagram& diagram, const std::vector<Point>& points) {
  std::vector<Found> found;
  found.reserve(points.size());
  const auto circles = Finder(diagram).findAll(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const CircleIndex circle = circles[i];
    found.push_back({circle, circle == kNone ? 0 : distanceFrom(diagram, circle, points[i])});
  }
  return found;
}

std::vector<Found> foundOnSphere(const CLI::App& command, FindArguments& arguments, const std::string& text,
                                 const std::vector<Circle>& points, ProgressLine& progress) {
  for (const char* option : {"--project", "--metric"}) {
    if (command.count(option) > 0) throw CommandError{kBadInput, std::string("--sphere takes no ") + option + "."};
  }
  CircleFile file = readInput(arguments.input, text);
  const SphereDiagram diagram = diagramOnSphere(arguments.sphere, arguments.input, file, Options{}.threads, progress);
  arguments.output.attributes = std::move(file.attributes);
  const SphereFinder finder(diagram);
  std::vector<Found> found;
  for (const Circle& p : points) {
    const CircleIndex circle = finder.find(p.x, p.y);
    found.push_back({circle, circle == kNone ? 0 : distanceFrom(diagram, circle, p.x, p.y)});
  }
  return found;
}

void runFind(const CLI::App& command, FindArguments& arguments) {
  settleInput(command, arguments.input);
  if (!arguments.sphere.isAsked && command.count("--unit") > 0) {
    throw CommandError{kBadInput, "--unit needs --sphere."};
  }
  if (arguments.input.file == kStandardStream && arguments.at == kStandardStream) {
    throw CommandError{kBadInput, "The circles and the points cannot both be standard input."};
  }
  refuseSharedFiles({arguments.input.file, arguments.at}, {{"--output", arguments.output.file}});
  ProgressLine progress(arguments.progress);
  progress.show("read");
  const CircleFile points = readInput({arguments.at, {.radii = Radii::none}}, readText(arguments.at));
  const std::string text = readText(arguments.input.file);
  const std::string name = inputName(arguments.input.file);
  std::vector<Found> found;
  if (arguments.sphere.isAsked) {
    found = foundOnSphere(command, arguments, text, points.circles, progress);
  } else {
    const Diagram diagram = diagramOf(command, arguments, text, name, progress);
    const auto& projection = arguments.output.projection;
    std::vector<Point> places;
    for (const Circle& p : points.circles) {
      places.push_back(projection ? projection->plane(Point{p.x, p.y}) : Point{p.x, p.y});
    }
    progress.show("find");
    found = foundIn(diagram, places);
  }
  write(arguments.output, inputName(arguments.at), progress, [&](std::ostream& out) {
    return writeFoundCsv(out, points.circles, points.attributes, found, arguments.output.attributes.ids);
  });
}

}  // namespace

void addFindCommand(CLI::App& program) {
  const auto arguments = std::make_shared<FindArguments>();
  CLI::App* command = program.add_subcommand("find", "Find the cell of each point of a file, and its distance");
  addCirclesInput(*command, arguments->input,
                  "Circles as compute reads them, or a diagram as JSON; - is standard input");
  command
      ->add_option("--at", arguments->at,
                   "The points, in a file with columns x and y, JSON, GeoJSON or well-known text; - is standard input")
      ->type_name("FILE")
      ->required();
  addMetricOption(*command, arguments->metric);
  addProjectOption(*command, arguments->projection);
  addSphereOptions(*command, arguments->sphere);
  addOutputFile(*command, arguments->output);
  addProgressOption(*command, arguments->progress);
  command->footer(
      "The output is a table (CSV): x, y, circle (the index of the nearest circle from 0), circle_id (if circles have\n"
      "ids), distance, and all other columns of the points. If several circles are equally near, one of them is "
      "named.");
  command->callback([arguments, command] { runFind(*command, *arguments); });
}

}  // namespace circle_voronoi::cli
