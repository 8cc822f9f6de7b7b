// SPDX-License-Identifier: GPL-3.0-or-later
#include "circles_input.h"

#include <array>
#include <iostream>
#include <utility>

#include "command_error.h"
#include "files.h"
#include "option_flag.h"

namespace circle_voronoi::cli {
namespace {

const auto kMetricChoices = choices<Metric>();
const std::string kWeights = flagOf(&Options::weights);
constexpr std::array<const char*, 7> kColumnOptions = {"--x",  "--y", "--radius", "--points", "--id", "--skip-invalid",
                                                       "--crs"};

bool isGiven(const CLI::App& command, const std::string& option) {
  return command.get_option_no_throw(option) != nullptr && command.count(option) > 0;
}

}  // namespace

void addCirclesInput(CLI::App& command, CirclesInput& input, const std::string& description, Skipping skipping,
                     Radii radii) {
  input.options.radii = radii;
  // settleInput checks whether the file is missing, because --weights may hold its name.
  command.add_option("FILE", input.file, description)->type_name("");
  command
      .add_option(kWeights, input.options.radius,
                  "Radii are additive weights and may be negative; COLUMN, if it is given, has them")
      ->type_name("COLUMN")
      ->expected(0, 1);
  const auto addColumn = [&](const char* name, std::string& column, const char* what) {
    return command.add_option(name, column, what)->type_name("COLUMN");
  };
  addColumn("--x", input.options.x, "The column, or the member of JSON objects, that has x");
  addColumn("--y", input.options.y, "The column, or the member of JSON objects, that has y");
  CLI::Option* radius =
      addColumn("--radius", input.options.radius, "The column, property or member that has the radius");
  command
      .add_flag_callback(
          "--points", [&input] { input.options.radii = Radii::none; }, "All radii are 0; no column is needed for them")
      ->excludes(radius);
  addColumn("--id", input.options.id, "The column, property or member that has the id; by default id");
  if (skipping == Skipping::possible) {
    command.add_flag("--skip-invalid", input.options.skipInvalid,
                     "Skip rows and features that are no circles, and say how many there are");
  }
}

void addCrsOption(CLI::App& command, CirclesInput& input) {
  command
      .add_option("--crs", input.options.crs,
                  "The coordinate reference system of the centers, such as EPSG:25832, which GeoJSON names; by default "
                  "as the input says")
      ->type_name("NAME");
}

void addMetricOption(CLI::App& command, std::string& metric) {
  command
      .add_option("--metric", metric,
                  "The distance from a circle: circles |p - c| - r, centers |p - c|, or power |p - c|^2 - r^2")
      ->type_name("METRIC")
      ->check(CLI::IsMember(&kMetricChoices))
      ->capture_default_str();
}

Metric metricNamed(const std::string& name) { return kMetricChoices.at(name); }

void settleInput(const CLI::App& command, CirclesInput& input) {
  ReadOptions& options = input.options;
  options.weights = isGiven(command, kWeights);
  if (options.weights) {
    const bool hasRadius = isGiven(command, "--radius");
    std::string word =
        command.get_option(kWeights)->results().empty() ? "" : command.get_option(kWeights)->results()[0];
    if (input.file.empty()) std::swap(input.file, word);
    if (hasRadius && !word.empty()) throw CommandError{kBadInput, kWeights + " " + word + " takes no --radius."};
    if (isGiven(command, "--points")) throw CommandError{kBadInput, kWeights + " takes no --points."};
    options.radius = hasRadius ? command.get_option("--radius")->as<std::string>() : word;
  }
  if (isGiven(command, "--crs")) {
    for (const char* option : {"--project", "--sphere"}) {
      if (!isGiven(command, option)) continue;
      throw CommandError{kBadInput, std::string(option) + " takes no --crs: centers are longitude and latitude."};
    }
  }
  if (input.file.empty()) throw CommandError{kBadInput, "FILE is required"};
}

void refuseColumnOptions(const CLI::App& command, const std::string& name) {
  const auto refuse = [&](const std::string& option) {
    if (!isGiven(command, option)) return;
    throw CommandError{kBadInput,
                       name + ": " + option + " is for circles alone; a diagram's file says what its circles are."};
  };
  refuse(kWeights);
  for (const char* option : kColumnOptions) refuse(option);
}

CircleFile readInput(const CirclesInput& input, const std::string& text) {
  auto file = readCircleFile(text, inputName(input.file), input.options);
  if (!file) fail(file.error(), "");
  return *std::move(file);
}

void noteSkipped(const CircleFile& file, ProgressLine& progress) {
  const std::size_t count = file.skipped.size();
  if (count == 0) return;
  note(std::to_string(count) + " of " + std::to_string(count + file.circles.size()) + (count == 1 ? " was" : " were") +
           " skipped; the first: " + file.skipped.front().message,
       progress);
}

void noteHidden(const std::string& warning, const std::string& options, ProgressLine& progress) {
  if (!warning.empty()) note(warning + " See " + options + ".", progress);
}

void noteDegrees(const CircleFile& file, ProgressLine& progress) {
  if (!file.areDegrees) return;
  note(
      "The centers are longitude and latitude, and the diagram is that of a plane where all degrees are equally long. "
      "For the Earth, see --sphere and --project.",
      progress);
}

void note(const std::string& sentence, ProgressLine& progress) {
  progress.end();
  std::cerr << "circle-voronoi: " << sentence << '\n';
}

}  // namespace circle_voronoi::cli
