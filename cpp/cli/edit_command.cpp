// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "change_lines.h"
#include "circle_voronoi/editor.h"
#include "circle_voronoi/io.h"
#include "commands.h"
#include "edit_script.h"
#include "failure.h"
#include "files.h"
#include "output.h"
#include "progress_line.h"
#include "trace_lines.h"
#include "weights_option.h"

namespace circle_voronoi::cli {
namespace {

struct EditArguments {
  std::string input;
  std::string script;
  std::string changes;
  std::string trace;
  bool weights = EditorOptions{}.weights;
  Output output;
  std::string progress = "auto";
};

/// Reads the circles to be edited. Sets `weights` if the file of a diagram says so.
std::vector<Circle> readEditedCircles(const std::string& input, bool& weights) {
  const std::string name = inputName(input);
  const std::string text = readText(input);
  if (!holdsDiagram(text)) {
    auto circles = readCircles(text, name, {weights});
    if (!circles) fail(circles.error(), "");
    return *std::move(circles);
  }
  auto diagram = readDiagram(text, name);
  if (!diagram) fail(diagram.error(), "");
  weights = diagram->weights;
  const Metric metric = diagram->metric;
  if (metric != Metric::circles) {
    throw Failure{kBadInput, name + ": the metric " + std::string(metricName(metric)) +
                                 " cannot be edited, only that of circles."};
  }
  return std::move(diagram->circles);
}

/// Makes the edits of a script, and tells each change.
void makeEdits(DiagramEditor& editor, const EditArguments& arguments, std::ostream* changes, ProgressLine& progress) {
  progress.show("read");
  const std::string name = inputName(arguments.script);
  const std::vector<ScriptEdit> edits = readScript(readText(arguments.script), name);
  double done = 0;
  for (const auto& [edit, line] : edits) {
    progress.show("edit", done++ / static_cast<double>(edits.size()));
    const auto change = editor.apply({&edit, 1});
    if (!change) fail(change.error(), name + ":" + std::to_string(line) + ": ");
    if (changes != nullptr) writeChange(*changes, change.value());
  }
}

void runEdit(EditArguments& arguments) {
  settle(arguments.output);
  if (arguments.input == kStandardStream && arguments.script == kStandardStream) {
    throw Failure{kBadInput, "The circles and the script cannot both be standard input."};
  }
  refuseSharedFiles(
      {arguments.input, arguments.script, arguments.output.regionFile},
      {{"--output", arguments.output.file}, {"--changes", arguments.changes}, {"--trace", arguments.trace}});
  ProgressLine progress(arguments.progress);
  progress.show("read");
  const std::vector<Circle> circles = readEditedCircles(arguments.input, arguments.weights);
  progress.show("compute");
  auto made = DiagramEditor::from(circles, {arguments.weights});
  if (!made) fail(made.error(), inputName(arguments.input) + ": ");
  DiagramEditor editor = std::move(made).value();
  const auto makeAll = [&](std::ostream* changes) { makeEdits(editor, arguments, changes, progress); };
  const auto makeAndWrite = [&](const std::string& file) {
    if (file.empty()) return makeAll(nullptr);
    writeText(file, [&](std::ostream& out) { makeAll(&out); });
  };
  if (arguments.trace.empty()) {
    makeAndWrite(arguments.changes);
  } else {
    // One file is written after the other.
    std::ostringstream changes;
    writeText(arguments.trace, [&](std::ostream& out) {
      const auto observed = editor.observe([&out](const TraceEvent& event) { writeTraceEvent(out, event); });
      if (!observed) fail(observed.error(), inputName(arguments.input) + ": ");
      makeAll(arguments.changes.empty() ? nullptr : &changes);
      (void)editor.observe({});  // nothing to fail
    });
    if (!arguments.changes.empty()) writeText(arguments.changes, [&](std::ostream& out) { out << changes.str(); });
  }
  const auto diagram = editor.snapshot();
  if (!diagram) fail(diagram.error(), inputName(arguments.input) + ": ");
  writeDiagram(arguments.output, inputName(arguments.input), diagram.value(), progress);
}

}  // namespace

void addEditCommand(CLI::App& program) {
  const auto arguments = std::make_shared<EditArguments>();
  CLI::App* command = program.add_subcommand("edit", "Insert, remove and replace circles of a diagram");
  command
      ->add_option("FILE", arguments->input, "Circles as compute reads them, or a diagram as JSON; - is standard input")
      ->type_name("")
      ->required();
  command
      ->add_option("--script", arguments->script,
                   "The edits, one per line: insert,x,y,r or remove,id or replace,id,x,y,r; - is standard input")
      ->type_name("FILE")
      ->required();
  command
      ->add_option("--changes", arguments->changes,
                   "Write what each edit changes to this file, one line of JSON per edit")
      ->type_name("FILE");
  command->add_option("--trace", arguments->trace, "Write the events to this file, one line of JSON per event")
      ->type_name("FILE");
  addWeightsOption(*command, arguments->weights);
  addOutputOptions(*command, arguments->output);
  addProgressOption(*command, arguments->progress);
  command->footer(
      "Circle i of the file has id i; each circle that is inserted gets the next one. The first edit that cannot be "
      "made\nends the program. Formats are those of compute.");
  command->callback([arguments] { runEdit(*arguments); });
}

}  // namespace circle_voronoi::cli
