// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "box.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/compute_periodic.h"
#include "circle_voronoi/hidden_warning.h"
#include "circle_voronoi/io.h"
#include "circle_voronoi/periodic_diagram.h"
#include "circle_voronoi/progress.h"
#include "circles_input.h"
#include "command_error.h"
#include "commands.h"
#include "files.h"
#include "option_flag.h"
#include "output.h"
#include "progress_line.h"
#include "sphere_part.h"
#include "tile_part.h"
#include "trace_lines.h"
#include "whole_number.h"

namespace circle_voronoi::cli {
namespace {

const auto kMethodChoices = choices<Method>();
const auto kCandidatesChoices = choices<Candidates>();

constexpr int kMaxThreads = 1024;

struct ComputeArguments {
  CirclesInput input;
  std::string projection;
  Output output;
  std::string metric{nameOf(Options{}.metric)};
  std::string method{nameOf(Options{}.method)};
  std::string candidates{nameOf(Options{}.candidates)};
  std::optional<int> samples = Options{}.samples;
  bool resample = Options{}.resample;
  int threads = Options{}.threads;
  std::string trace;
  std::string lattice;  ///< AX,AY,BX,BY; empty if the circles do not repeat
  SpherePart sphere;
  TilePart tile;
  std::string progress = "auto";
};

/// Throws CommandError if an option would have no effect.
void refuseUnused(const CLI::App& command, const ComputeArguments& arguments) {
  const auto refuse = [&](const std::string& option, bool isUsed, const std::string& need) {
    if (command.count(option) > 0 && !isUsed) throw CommandError{kBadInput, option + " needs " + need + "."};
  };
  const std::string samples = flagOf(&Options::samples);
  const std::string resample = flagOf(&Options::resample);
  const Method method = kMethodChoices.at(arguments.method);
  const Candidates candidates = kCandidatesChoices.at(arguments.candidates);
  const auto needed = [](auto field, auto value) { return flagOf(field) + " " + std::string(nameOf(value)); };
  for (const std::string& option : {flagOf(&Options::candidates), samples, resample}) {
    refuse(option, method == Method::touchingDisc, needed(&Options::method, Method::touchingDisc));
  }
  refuse(samples, candidates != Candidates::allPairs,
         needed(&Options::candidates, Candidates::dynamic) + " or " + std::string(nameOf(Candidates::uniform)));
  refuse(resample, candidates == Candidates::dynamic, needed(&Options::candidates, Candidates::dynamic));
  refuse("--known", method == Method::automatic, needed(&Options::method, Method::automatic));
  const Metric metric = metricNamed(arguments.metric);
  const std::string circles = "--metric " + std::string(nameOf(Metric::circles));
  for (const std::string& option :
       {flagOf(&Options::method), std::string("--trace"), std::string("--known"), std::string("--sphere")}) {
    refuse(option, metric == Metric::circles, circles);
  }
  if (!arguments.lattice.empty()) {
    refuse("--lattice", method == Method::automatic, needed(&Options::method, Method::automatic));
    if (arguments.tile.isAsked()) throw CommandError{kBadInput, "--lattice takes no --known."};
    if (!arguments.trace.empty()) throw CommandError{kBadInput, "--lattice takes no --trace."};
  }
  if (!arguments.tile.isAsked()) return;
  if (!arguments.trace.empty()) throw CommandError{kBadInput, "--known takes no --trace."};
  if (!arguments.projection.empty()) throw CommandError{kBadInput, "--known takes no --project."};
  if (arguments.input.options.skipInvalid) throw CommandError{kBadInput, "--known takes no --skip-invalid."};
}

void runCompute(const CLI::App& command, ComputeArguments& arguments) {
  settleInput(command, arguments.input);
  refuseUnused(command, arguments);
  arguments.output.isOnSphere = arguments.sphere.isAsked;
  settle(arguments.output);
  checkCrs(command, arguments.output);
  check(arguments.sphere, command, arguments.output);
  check(arguments.tile, arguments.output);
  if (!arguments.lattice.empty()) checkPeriodicOutput(arguments.output);
  refuseSharedFiles(
      {arguments.input.file, arguments.output.regionFile},
      {{"--output", arguments.output.file}, {"--trace", arguments.trace}, {"--open", arguments.tile.open}});
  ProgressLine progress(arguments.progress);
  progress.show("read");
  if (arguments.tile.isAsked()) {
    return computeTilePart(arguments.tile, arguments.output, arguments.input, arguments.threads, progress);
  }
  const std::string name = inputName(arguments.input.file);
  CircleFile file = readInput(arguments.input, readText(arguments.input.file));
  if (arguments.sphere.isAsked) {
    return computeOnSphere(arguments.sphere, arguments.output, arguments.input, std::move(file), arguments.threads,
                           progress);
  }
  if (arguments.projection.empty()) noteDegrees(file, progress);
  arguments.output.attributes = std::move(file.attributes);
  project(arguments.projection, file.circles, arguments.output, name, progress);
  const std::vector<Circle>& circles = file.circles;

  Options options;
  options.weights = arguments.input.weights();
  options.metric = metricNamed(arguments.metric);
  options.method = kMethodChoices.at(arguments.method);
  options.candidates = kCandidatesChoices.at(arguments.candidates);
  options.samples = arguments.samples;
  options.resample = arguments.resample;
  options.threads = arguments.threads;
  options.progress = [&](Stage stage, double done) { progress.show(stageName(stage), done); };
  if (!arguments.lattice.empty()) {
    Lattice lattice;
    (void)readLattice(arguments.lattice, lattice);
    const auto periodic = computePeriodic(circles, lattice, options);
    if (!periodic) fail(periodic.error(), name + ": ");
    noteSkipped(file, progress);
    return writePeriodicDiagram(arguments.output, name, *periodic, progress);
  }
  const auto computed = [&] {
    auto diagram = compute(circles, options);
    if (!diagram) fail(diagram.error(), name + ": ");
    return std::move(diagram).value();
  };
  Diagram diagram;
  if (arguments.trace.empty()) {
    diagram = computed();
  } else {
    writeText(arguments.trace, [&](std::ostream& out) {
      options.observer = [&](const TraceEvent& event) { writeTraceEvent(out, event); };
      diagram = computed();
    });
  }
  noteSkipped(file, progress);
  noteHidden(hiddenWarning(diagram), "--sphere, --project and --radius", progress);
  writeDiagram(arguments.output, name, diagram, progress);
}

}  // namespace

void addComputeCommand(CLI::App& program) {
  const auto arguments = std::make_shared<ComputeArguments>();
  CLI::App* command = program.add_subcommand("compute", "Compute the Voronoi diagram of the circles in a file");
  addCirclesInput(
      *command, arguments->input,
      "Circles: CSV x,y,r or with a header, JSON, or GeoJSON points with a property r; - is standard input");
  addCrsOption(*command, arguments->input);
  addProjectOption(*command, arguments->projection);
  addSphereOptions(*command, arguments->sphere);
  addOutputOptions(*command, arguments->output);
  addMetricOption(*command, arguments->metric);
  command->add_option(flagOf(&Options::method), arguments->method, "How to build the diagram")
      ->type_name("METHOD")
      ->check(CLI::IsMember(&kMethodChoices))
      ->capture_default_str();
  command
      ->add_option(flagOf(&Options::candidates), arguments->candidates,
                   "touching-disc: which pairs of circles get an antipodal disc")
      ->type_name("CANDIDATES")
      ->check(CLI::IsMember(&kCandidatesChoices))
      ->capture_default_str();
  command
      ->add_option(flagOf(&Options::samples), arguments->samples,
                   "dynamic: samples inside each angle of a Delaunay face (" + std::to_string(kDefaultDynamicSamples) +
                       "); uniform: samples on each circle (" + std::to_string(kDefaultUniformSamples) + ")")
      ->type_name("COUNT")
      ->transform(wholeNumber(kMaxSamples).description("0 to " + std::to_string(kMaxSamples)));
  command->add_flag(flagOf(&Options::resample), arguments->resample,
                    "dynamic: take more samples where the certificate failed and try again");
  command
      ->add_option("--threads", arguments->threads,
                   "How many threads may work at the same time; 0 for as many as the machine has")
      ->type_name("COUNT")
      ->capture_default_str()
      ->transform(wholeNumber(kMaxThreads).description("0 to " + std::to_string(kMaxThreads)));
  addLatticeOption(*command, arguments->lattice);
  command
      ->add_option("--trace", arguments->trace,
                   "Write the events of the method to this file, one line of JSON per event")
      ->type_name("FILE");
  addTileOptions(*command, arguments->tile);
  addProgressOption(*command, arguments->progress);
  command->footer(
      "Formats:\n"
      "  json      the diagram: circles, hidden circles, vertices, edges, hull and stats\n"
      "  csv       its vertices and edges; with --lattice the neighbors of each circle, with borders and gaps\n"
      "  cells     a table (CSV) of the cells: circle, x, y, r, area, perimeter, neighbors, and all other columns\n"
      "  svg       a drawing with true curves, a group for each layer\n"
      "  geojson   the cells as polygons, with circle, r, area and neighbors\n"
      "  geojsonl  the same features, one per line\n"
      "  wkt       the cells as well-known text, a line for each circle\n"
      "  obj       the edges and cells as Wavefront OBJ\n"
      "  stats     what was done, how long it took, and the certificate");
  command->callback([arguments, command] { runCompute(*command, *arguments); });
}

}  // namespace circle_voronoi::cli
