// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <iomanip>
#include <limits>
#include <memory>
#include <ostream>
#include <sstream>
#include <string>

#include "circle_voronoi/io.h"
#include "circle_voronoi_families/families.h"
#include "command_error.h"
#include "commands.h"
#include "files.h"
#include "output.h"
#include "whole_number.h"

namespace circle_voronoi::cli {
namespace {

/// The largest number of circles: they fit in memory, though their diagram would not.
constexpr std::int64_t kMostCircles = 100'000'000;
/// Longer than the name of any family.
constexpr int kNameWidth = 22;

struct GenerateArguments {
  std::string family;
  std::int64_t count = 0;
  std::uint64_t seed = 1;
  Output output;
};

void runGenerate(const GenerateArguments& arguments) {
  const auto family = familyFromName(arguments.family);
  if (!family) throw CommandError{kBadInput, "There is no family \"" + arguments.family + "\"; see generate --list."};
  const std::string ending = endingOf(arguments.output.file);
  if (!ending.empty() && ending != "csv") {
    throw CommandError{kBadInput, arguments.output.file + ": generate writes csv, not " + ending + "; see convert."};
  }
  const auto circles = generate(*family, static_cast<std::size_t>(arguments.count), arguments.seed);
  writeText(arguments.output.file, [&](std::ostream& out) { checkWritten(writeCirclesCsv(out, circles), ""); });
}

/// A line for each family: its name and its description.
std::string listOfFamilies(std::string_view indent) {
  std::ostringstream list;
  for (const FamilyInfo& info : families()) {
    list << indent << std::left << std::setw(kNameWidth) << info.name << info.description << '\n';
  }
  return list.str();
}

}  // namespace

void addGenerateCommand(CLI::App& program) {
  const auto arguments = std::make_shared<GenerateArguments>();
  CLI::App* command = program.add_subcommand("generate", "Write a random set of circles as CSV");
  command->add_option("FAMILY", arguments->family, "The name of a family; the families are listed below")
      ->type_name("")
      ->required();
  command->add_option("N", arguments->count, "The number of circles, at most " + std::to_string(kMostCircles))
      ->type_name("")
      ->required()
      ->transform(wholeNumber(kMostCircles));
  command->add_option("--seed", arguments->seed, "The same seed gives the same circles")
      ->type_name("SEED")
      ->transform(wholeNumber(std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
  addOutputFile(*command, arguments->output);
  command->add_flag_callback(
      "--list",
      [] {
        writeText(kStandardStream, [](std::ostream& out) { out << listOfFamilies(""); });
        throw CLI::Success();
      },
      "Print the names of the families, each with what it is");
  command->footer("Families; a figure is that of the paper:\n" + listOfFamilies("  "));
  command->callback([arguments] { runGenerate(*arguments); });
}

}  // namespace circle_voronoi::cli
