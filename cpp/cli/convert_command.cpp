// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <string>

#include "circle_voronoi/certify.h"
#include "circle_voronoi/io.h"
#include "circle_voronoi/progress.h"
#include "circles_input.h"
#include "command_error.h"
#include "commands.h"
#include "files.h"
#include "output.h"
#include "progress_line.h"

namespace circle_voronoi::cli {
namespace {

struct ConvertArguments {
  CirclesInput input;
  Output output;
  bool circlesAlone = false;
  std::string progress = "auto";
};

void convertCircles(ConvertArguments& arguments, const std::string& text, ProgressLine& progress) {
  CircleFile file = readInput(arguments.input, text);
  arguments.output.attributes = std::move(file.attributes);
  noteSkipped(file, progress);
  writeCircles(arguments.output, inputName(arguments.input.file), file.circles, progress);
}

void convertDiagram(const CLI::App& command, ConvertArguments& arguments, const std::string& text,
                    ProgressLine& progress) {
  const std::string name = inputName(arguments.input.file);
  refuseColumnOptions(command, name);
  auto read = readDiagramFile(text, name);
  if (!read) throw CommandError{kBadInput, read.error().message};
  Diagram& diagram = read->diagram;
  arguments.output.attributes = std::move(read->attributes);
  takeRecordedProjection(arguments.output, arguments.output.attributes);
  if (arguments.circlesAlone) {
    if (const auto& projection = arguments.output.projection) {
      for (Circle& circle : diagram.circles) circle = projection->degrees(circle);
      Projection::removeFrom(arguments.output.attributes);
    }
    return writeCircles(arguments.output, name, diagram.circles, progress);
  }
  progress.show(stageName(Stage::certify));
  // The output is drawn from the diagram, so the diagram must be valid whatever its file claims.
  const auto certificate = certify(diagram);
  if (!certificate) throw CommandError{kBadInput, name + ": " + certificate.error().message};
  diagram.certificate = certificate.value();
  writeDiagram(arguments.output, name, diagram, progress);
}

void runConvert(const CLI::App& command, ConvertArguments& arguments) {
  settleInput(command, arguments.input);
  settle(arguments.output);
  checkCrs(command, arguments.output);
  refuseSharedFiles({arguments.input.file, arguments.output.regionFile}, {{"--output", arguments.output.file}});
  ProgressLine progress(arguments.progress);
  progress.show("read");
  const std::string text = readText(arguments.input.file);
  if (holdsDiagram(text)) return convertDiagram(command, arguments, text, progress);
  convertCircles(arguments, text, progress);
}

}  // namespace

void addConvertCommand(CLI::App& program) {
  const auto arguments = std::make_shared<ConvertArguments>();
  CLI::App* command =
      program.add_subcommand("convert", "Write circles, or a diagram that was computed, in another format");
  addCirclesInput(*command, arguments->input,
                  "Circles as compute reads them, or a diagram as JSON; - is standard input");
  addCrsOption(*command, arguments->input);
  addOutputOptions(*command, arguments->output);
  command->add_flag("--circles", arguments->circlesAlone, "Of a diagram, write the circles alone");
  addProgressOption(*command, arguments->progress);
  command->footer(
      "Circles become csv, json or geojson (points with a property r). A diagram becomes any format of compute, "
      "without "
      "being\n"
      "computed again.");
  command->callback([arguments, command] { runConvert(*command, *arguments); });
}

}  // namespace circle_voronoi::cli
