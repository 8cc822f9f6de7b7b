// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "circle_voronoi/compute.h"
#include "circle_voronoi/io.h"
#include "circle_voronoi/progress.h"
#include "commands.h"
#include "failure.h"
#include "files.h"
#include "output.h"
#include "progress_line.h"
#include "tile_part.h"
#include "weights_option.h"

namespace circle_voronoi::cli {
namespace {

const std::map<std::string, Method> kMethods = {
    {"auto", Method::automatic}, {"touching-disc", Method::touchingDisc}, {"flip", Method::flip}};
const std::map<std::string, Candidates> kCandidates = {
    {"dynamic", Candidates::dynamic}, {"uniform", Candidates::uniform}, {"all-pairs", Candidates::allPairs}};

struct ComputeArguments {
  std::string input;
  Output output;
  bool weights = Options{}.weights;
  std::string method = "auto";
  std::string candidates = "dynamic";
  int samples = Options{}.samples;
  bool resample = Options{}.resample;
  TilePart tile;
  std::string progress = "auto";
};

/// Throws Failure if an option is given that would not be used.
void refuseUnused(const CLI::App& command, const ComputeArguments& arguments) {
  const auto refuse = [&](const char* option, bool isUsed, const std::string& need) {
    if (command.count(option) > 0 && !isUsed) throw Failure{kBadInput, std::string(option) + " needs " + need + "."};
  };
  const bool isTouchingDisc = arguments.method == "touching-disc";
  for (const char* option : {"--candidates", "--samples", "--resample"}) {
    refuse(option, isTouchingDisc, "--method touching-disc");
  }
  refuse("--samples", arguments.candidates != "all-pairs", "--candidates dynamic or uniform");
  refuse("--resample", arguments.candidates == "dynamic", "--candidates dynamic");
  refuse("--known", arguments.method == "auto", "--method auto");
}

void runCompute(const CLI::App& command, ComputeArguments& arguments) {
  refuseUnused(command, arguments);
  settle(arguments.output, arguments.input);
  check(arguments.tile, arguments.output);
  ProgressLine progress(arguments.progress);
  progress.show("read");
  if (arguments.tile.isAsked()) {
    return computeTilePart(arguments.tile, arguments.output, arguments.input, arguments.weights, progress);
  }
  const std::string name = inputName(arguments.input);
  const auto circles = readCircles(readText(arguments.input), name, {arguments.weights});
  if (!circles) throw Failure{kBadInput, circles.error().message};

  Options options;
  options.weights = arguments.weights;
  options.method = kMethods.at(arguments.method);
  options.candidates = kCandidates.at(arguments.candidates);
  options.samples = arguments.samples;
  options.resample = arguments.resample;
  options.progress = [&](Stage stage, double done) { progress.show(stageName(stage), done); };
  const auto diagram = compute(circles.value(), options);
  if (!diagram) {
    const Error& error = diagram.error();
    throw Failure{error.code == ErrorCode::notCertified ? kFailure : kBadInput, name + ": " + error.message};
  }
  writeDiagram(arguments.output, name, diagram.value(), progress);
}

}  // namespace

void addComputeCommand(CLI::App& program) {
  const auto arguments = std::make_shared<ComputeArguments>();
  CLI::App* command = program.add_subcommand("compute", "Compute the Voronoi diagram of the circles in a file");
  command
      ->add_option(
          "FILE", arguments->input,
          "Circles: CSV x,y,r or with a header, JSON, or GeoJSON points with a property radius; - is standard input")
      ->type_name("")
      ->required();
  addWeightsOption(*command, arguments->weights);
  addOutputOptions(*command, arguments->output);
  command->add_option("--method", arguments->method, "How to build the diagram")
      ->type_name("METHOD")
      ->check(CLI::IsMember(&kMethods))
      ->capture_default_str();
  command
      ->add_option("--candidates", arguments->candidates, "touching-disc: which pairs of circles get an antipodal disc")
      ->type_name("CANDIDATES")
      ->check(CLI::IsMember(&kCandidates))
      ->capture_default_str();
  command
      ->add_option("--samples", arguments->samples,
                   "dynamic: samples inside each angle of a Delaunay face (" + std::to_string(kDefaultDynamicSamples) +
                       "); uniform: samples on each circle (" + std::to_string(kDefaultUniformSamples) + ")")
      ->type_name("COUNT")
      ->check(CLI::Range(0, kMaxSamples).description("0 to " + std::to_string(kMaxSamples)));
  command->add_flag("--resample", arguments->resample,
                    "dynamic: take more samples where the certificate failed and try again");
  addTileOptions(*command, arguments->tile);
  addProgressOption(*command, arguments->progress);
  command->footer(
      "Formats:\n"
      "  json      the diagram: circles, hidden circles, vertices, edges, hull and stats\n"
      "  csv       its vertices and edges\n"
      "  svg       a drawing with true curves, a group for each layer\n"
      "  geojson   the cells as polygons, with circle, radius, area and neighbors\n"
      "  geojsonl  the same features, one a line\n"
      "  wkt       the cells as well-known text, a line for each circle\n"
      "  obj       the edges and cells as Wavefront OBJ\n"
      "  stats     what was done, how long it took, and the certificate");
  command->callback([arguments, command] { runCompute(*command, *arguments); });
}

}  // namespace circle_voronoi::cli
