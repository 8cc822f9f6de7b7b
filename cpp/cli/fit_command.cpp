// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "box.h"
#include "circle_voronoi/fit_areas.h"
#include "circle_voronoi/io.h"
#include "circles_input.h"
#include "command_error.h"
#include "commands.h"
#include "files.h"
#include "metrics.h"
#include "output.h"
#include "progress_line.h"
#include "whole_number.h"

namespace circle_voronoi::cli {
namespace {

/// The areas that are all the same.
constexpr const char* kEqual = "equal";

struct FitArguments {
  CirclesInput input;
  std::string projection;
  Output output;
  std::string lattice;  ///< AX,AY,BX,BY; empty if the cells divide a region
  std::string areas;
  std::string metric{metricName(AreaFitOptions{}.metric)};
  bool shares = AreaFitOptions{}.shares;
  double areaTolerance = AreaFitOptions{}.tolerance;
  int maxSteps = AreaFitOptions{}.maxSteps;
  int relax = AreaFitOptions{}.relax;
  std::string progress = "auto";
};

/// The progress of a fit: the position of its error between the first error and the tolerance, in orders of magnitude.
double partDone(double first, double error, double tolerance) {
  if (!(first > tolerance) || !(error > tolerance)) return 1;
  return std::clamp(std::log(first / error) / std::log(first / tolerance), 0.0, 1.0);
}

/// Tells of areas whose error exceeds the tolerance, because last bits allow no less.
void noteError(double error, ProgressLine& progress) {
  std::array<char, 32> digits{};
  char* const end =
      std::to_chars(digits.data(), digits.data() + digits.size(), error, std::chars_format::scientific).ptr;
  std::string text(digits.data(), end);
  // Two digits are enough.
  if (text[1] == '.') text.erase(3, text.find('e') - 3);
  note("The largest relative error of an area is " + text +
           ", as the last bits of coordinates and weights allow no better areas.",
       progress);
}

void runFit(const CLI::App& command, FitArguments& arguments) {
  settleInput(command, arguments.input);
  if (arguments.lattice.empty() == arguments.output.regionFile.empty()) {
    throw CommandError{kBadInput, arguments.lattice.empty() ? "fit needs --region or --lattice."
                                                            : "--lattice takes no --region: cells are written whole."};
  }
  settle(arguments.output);
  checkCrs(command, arguments.output);
  if (!arguments.lattice.empty()) checkPeriodicOutput(arguments.output);
  refuseSharedFiles({arguments.input.file, arguments.output.regionFile}, {{"--output", arguments.output.file}});
  ProgressLine progress(arguments.progress);
  progress.show("read");
  const std::string name = inputName(arguments.input.file);
  CircleFile file = readInput(arguments.input, readText(arguments.input.file));
  const bool areEqual = arguments.areas == kEqual;
  const auto areas =
      areEqual ? std::vector<double>(file.circles.size(), 1.0) : numbersIn(file.attributes, arguments.areas);
  if (!areas) throw CommandError{kBadInput, name + ": " + areas.error().message};
  if (arguments.projection.empty()) noteDegrees(file, progress);
  arguments.output.attributes = std::move(file.attributes);
  project(arguments.projection, file.circles, arguments.output, name, progress);

  AreaFitOptions options;
  options.metric = kWeightedMetrics.at(arguments.metric);
  options.shares = arguments.shares || areEqual;
  options.tolerance = arguments.areaTolerance;
  options.maxSteps = arguments.maxSteps;
  options.relax = arguments.relax;
  double first = 0;
  options.onStep = [&](const AreaFitStep& step) {
    if (step.step == 0) first = step.error;
    progress.show("fit", partDone(first, step.error, options.tolerance));
  };
  const auto found = [&](auto fit) {
    if (!fit) fail(fit.error(), name + ": ");
    noteSkipped(file, progress);
    if (fit->error > options.tolerance) noteError(fit->error, progress);
    return std::move(fit).value();
  };
  if (arguments.lattice.empty()) {
    const AreaFit fit = found(fitAreas(file.circles, *areas, *arguments.output.region, options));
    return writeDiagram(arguments.output, name, fit.diagram, progress);
  }
  Lattice lattice;
  (void)readLattice(arguments.lattice, lattice);
  const PeriodicAreaFit fit = found(fitAreas(file.circles, *areas, lattice, options));
  writePeriodicDiagram(arguments.output, name, fit.periodic, progress);
}

}  // namespace

void addFitCommand(CLI::App& program) {
  const auto arguments = std::make_shared<FitArguments>();
  CLI::App* command =
      program.add_subcommand("fit", "Find weights for which the cells have given areas in a region or a box");
  addCirclesInput(*command, arguments->input,
                  "Sites, as the circles that compute reads; r is the weight to start from, 0 if there is none",
                  Skipping::possible, Radii::optional);
  addCrsOption(*command, arguments->input);
  command
      ->add_option("--areas", arguments->areas,
                   "The column or property that has the area of each cell; equal divides the region into equal parts")
      ->type_name("COLUMN")
      ->required();
  command
      ->add_option("--metric", arguments->metric,
                   "The distance: circles |p - c| - weight, or power |p - c|^2 - weight, with straight borders")
      ->type_name("METRIC")
      ->check(CLI::IsMember(&kWeightedMetrics))
      ->capture_default_str();
  command->add_flag("--shares", arguments->shares, "The areas are shares of the area of the region or box");
  command->add_option("--area-tolerance", arguments->areaTolerance, "The largest relative error allowed for each area")
      ->type_name("NUMBER")
      ->capture_default_str();
  command->add_option("--max-steps", arguments->maxSteps, "The largest number of steps")
      ->type_name("COUNT")
      ->capture_default_str();
  command
      ->add_option("--relax", arguments->relax,
                   "How many times all sites move to the centroids of their cells before the last fit")
      ->type_name("COUNT")
      ->capture_default_str();
  addProjectOption(*command, arguments->projection);
  arguments->output.isRegionNeeded = true;
  addOutputOptions(*command, arguments->output);
  command->get_option("--region")
      ->description("A file with the region that the cells divide, as GeoJSON or well-known text");
  addLatticeOption(*command, arguments->lattice);
  addProgressOption(*command, arguments->progress);
  command->footer("The result is the diagram of the sites with these weights, in any format of compute.");
  command->callback([arguments, command] { runFit(*command, *arguments); });
}

}  // namespace circle_voronoi::cli
