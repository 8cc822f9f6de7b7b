// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <memory>
#include <string>

#include "circle_voronoi/families.h"
#include "circle_voronoi/io.h"
#include "commands.h"
#include "failure.h"
#include "files.h"

namespace circle_voronoi::cli {
namespace {

/// Far more than fits in memory with its diagram, and few enough to be held.
constexpr std::int64_t kMostCircles = 100'000'000;

struct GenerateArguments {
  std::string family;
  std::int64_t count = 0;
  std::uint64_t seed = 1;
  std::string output = kStandardStream;
};

void runGenerate(const GenerateArguments& arguments) {
  const auto family = familyFromName(arguments.family);
  if (!family) throw Failure{kBadInput, "There is no family \"" + arguments.family + "\"; see generate --help."};
  const auto circles = generate(*family, static_cast<std::size_t>(arguments.count), arguments.seed);
  writeText(arguments.output, [&](std::ostream& out) { writeCsv(out, circles); });
}

std::string listOfFamilies() {
  std::string list = "Families:";
  for (const FamilyInfo& info : families()) {
    list += "\n  " + std::string(info.name) + ": " + std::string(info.description);
  }
  return list;
}

}  // namespace

void addGenerateCommand(CLI::App& program) {
  const auto arguments = std::make_shared<GenerateArguments>();
  CLI::App* command = program.add_subcommand("generate", "Write a random set of circles as CSV");
  command->add_option("FAMILY", arguments->family, "A family of the list below")->required();
  command->add_option("N", arguments->count, "How many circles")
      ->required()
      ->check(CLI::Range(std::int64_t{0}, kMostCircles));
  command->add_option("--seed", arguments->seed, "The same seed gives the same circles")->capture_default_str();
  command->add_option("-o,--output", arguments->output, "The file to write; - is standard output");
  command->footer(listOfFamilies());
  command->callback([arguments] { runGenerate(*arguments); });
}

}  // namespace circle_voronoi::cli
