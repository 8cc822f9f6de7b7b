// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <string>

#include "circle_voronoi/certify.h"
#include "circle_voronoi/io.h"
#include "circle_voronoi/progress.h"
#include "commands.h"
#include "failure.h"
#include "files.h"
#include "output.h"
#include "progress_line.h"
#include "weights_option.h"

namespace circle_voronoi::cli {
namespace {

struct ConvertArguments {
  std::string input;
  Output output;
  bool weights = false;
  bool circlesAlone = false;
  std::string progress = "auto";
};

void convertCircles(const ConvertArguments& arguments, const std::string& text, ProgressLine& progress) {
  const std::string name = inputName(arguments.input);
  const auto circles = readCircles(text, name, {arguments.weights});
  if (!circles) throw Failure{kBadInput, circles.error().message};
  writeCircles(arguments.output, name, *circles, progress);
}

void convertDiagram(const ConvertArguments& arguments, const std::string& text, ProgressLine& progress) {
  const std::string name = inputName(arguments.input);
  if (arguments.weights) {
    throw Failure{kBadInput, name + ": --weights is for circles alone; a diagram's file says what its radii are."};
  }
  auto read = readDiagram(text, name);
  if (!read) throw Failure{kBadInput, read.error().message};
  Diagram& diagram = read.value();
  if (arguments.circlesAlone) return writeCircles(arguments.output, name, diagram.circles, progress);
  progress.show(stageName(Stage::certify));
  // What is written is drawn from the diagram, so it has to be one, whatever its file says.
  const auto certificate = certify(diagram);
  if (!certificate) throw Failure{kBadInput, name + ": " + certificate.error().message};
  diagram.certificate = certificate.value();
  writeDiagram(arguments.output, name, diagram, progress);
}

void runConvert(ConvertArguments& arguments) {
  settle(arguments.output);
  refuseSharedFiles({arguments.input, arguments.output.regionFile}, {{"--output", arguments.output.file}});
  ProgressLine progress(arguments.progress);
  progress.show("read");
  const std::string text = readText(arguments.input);
  if (holdsDiagram(text)) return convertDiagram(arguments, text, progress);
  convertCircles(arguments, text, progress);
}

}  // namespace

void addConvertCommand(CLI::App& program) {
  const auto arguments = std::make_shared<ConvertArguments>();
  CLI::App* command =
      program.add_subcommand("convert", "Write circles, or a diagram that was computed, in another format");
  command
      ->add_option("FILE", arguments->input, "Circles as compute reads them, or a diagram as JSON; - is standard input")
      ->type_name("")
      ->required();
  addWeightsOption(*command, arguments->weights);
  addOutputOptions(*command, arguments->output);
  command->add_flag("--circles", arguments->circlesAlone, "Of a diagram, write the circles alone");
  addProgressOption(*command, arguments->progress);
  command->footer(
      "Circles become csv, json or geojson (points with a property r). A diagram becomes any format of compute, "
      "without "
      "being\n"
      "computed again.");
  command->callback([arguments] { runConvert(*arguments); });
}

}  // namespace circle_voronoi::cli
