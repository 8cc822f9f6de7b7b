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
#include "circles_input.h"
#include "command_error.h"
#include "commands.h"
#include "edit_script.h"
#include "files.h"
#include "output.h"
#include "progress_line.h"
#include "trace_lines.h"

namespace circle_voronoi::cli {
namespace {

struct EditArguments {
  CirclesInput input;
  std::string script;
  std::string changes;
  std::string trace;
  Output output;
  std::string progress = "auto";
};

/// Reads the circles to be edited. Sets whether they are weights if the file of a diagram says so.
CircleFile readEditedCircles(const CLI::App& command, CirclesInput& input) {
  const std::string name = inputName(input.file);
  const std::string text = readText(input.file);
  if (!holdsDiagram(text)) return readInput(input, text);
  refuseColumnOptions(command, name);
  auto file = readDiagramFile(text, name);
  if (!file) fail(file.error(), "");
  const Diagram& diagram = file->diagram;
  input.options.weights = diagram.weights;
  if (diagram.metric != Metric::circles) {
    throw CommandError{kBadInput, name + ": the metric " + std::string(metricName(diagram.metric)) +
                                      " cannot be edited, only that of circles."};
  }
  return {std::move(file->diagram.circles), std::move(file->attributes), {}};
}

/// Returns the attributes of circles by id. The circles of the file have their indices as ids. Inserted circles have no
/// attributes.
CircleAttributes attributesOf(CircleAttributes attributes, const std::vector<CircleId>& ids) {
  for (auto* list : {&attributes.properties, &attributes.ids, &attributes.heights}) {
    if (list->empty()) continue;
    std::vector<std::string> entries;
    for (const CircleId id : ids) {
      const auto index = static_cast<std::size_t>(id);
      entries.push_back(index < list->size() ? (*list)[index] : "");
    }
    *list = std::move(entries);
  }
  return attributes;
}

/// Makes the edits of a script, and reports each change.
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

void runEdit(const CLI::App& command, EditArguments& arguments) {
  settleInput(command, arguments.input);
  settle(arguments.output);
  checkCrs(command, arguments.output);
  if (arguments.input.file == kStandardStream && arguments.script == kStandardStream) {
    throw CommandError{kBadInput, "The circles and the script cannot both be standard input."};
  }
  refuseSharedFiles(
      {arguments.input.file, arguments.script, arguments.output.regionFile},
      {{"--output", arguments.output.file}, {"--changes", arguments.changes}, {"--trace", arguments.trace}});
  ProgressLine progress(arguments.progress);
  progress.show("read");
  CircleFile read = readEditedCircles(command, arguments.input);
  const std::string name = inputName(arguments.input.file);
  takeRecordedProjection(arguments.output, read.attributes);
  progress.show("compute");
  auto made = DiagramEditor::from(read.circles, {arguments.input.weights()});
  if (!made) fail(made.error(), name + ": ");
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
      if (!observed) fail(observed.error(), name + ": ");
      makeAll(arguments.changes.empty() ? nullptr : &changes);
      (void)editor.observe({});  // this call cannot fail
    });
    if (!arguments.changes.empty()) writeText(arguments.changes, [&](std::ostream& out) { out << changes.str(); });
  }
  const auto diagram = editor.snapshot();
  if (!diagram) fail(diagram.error(), name + ": ");
  const auto numbers = editor.numbers();
  if (!numbers) fail(numbers.error(), name + ": ");
  arguments.output.attributes = attributesOf(std::move(read.attributes), numbers->circles);
  noteSkipped(read, progress);
  writeDiagram(arguments.output, name, diagram.value(), progress);
}

}  // namespace

void addEditCommand(CLI::App& program) {
  const auto arguments = std::make_shared<EditArguments>();
  CLI::App* command = program.add_subcommand("edit", "Insert, remove and replace circles of a diagram");
  addCirclesInput(*command, arguments->input,
                  "Circles as compute reads them, or a diagram as JSON; - is standard input");
  addCrsOption(*command, arguments->input);
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
  addOutputOptions(*command, arguments->output);
  addProgressOption(*command, arguments->progress);
  command->footer(
      "Circle i of the file has id i; each circle that is inserted gets the next one.\n"
      "insert,id,x,y,r brings a removed circle back. The first edit that cannot be made\nends the program. Formats are "
      "those of compute.");
  command->callback([arguments, command] { runEdit(*command, *arguments); });
}

}  // namespace circle_voronoi::cli
