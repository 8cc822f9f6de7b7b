// SPDX-License-Identifier: GPL-3.0-or-later
// The manual page and the completion of bash, held against the program's own --help.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "circle_voronoi_families/families.h"
#include "cli.h"
#include "lines.h"

namespace circle_voronoi {
namespace {

using Words = std::set<std::string>;

const std::vector<std::string> kCommands = {"certify", "compute",  "convert", "edit",   "find",
                                            "fit",     "generate", "tile",    "treemap"};

Words wordsOf(const std::string& text) {
  std::istringstream in(text);
  Words words;
  for (std::string word; in >> word;) words.insert(word);
  return words;
}

/// The first group of each match, split at commas.
Words matches(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern, std::regex::multiline);
  std::string found;
  for (std::sregex_iterator match(text.begin(), text.end(), regex), end; match != end; ++match) {
    found += match->str(1) + " ";
  }
  return wordsOf(std::regex_replace(found, std::regex(","), " "));
}

class CliDocumentation : public test::Cli {
 protected:
  const std::string manual_ = readFile(CIRCLE_VORONOI_PROGRAM_SOURCES "/circle-voronoi.1");

  std::string help(const std::string& command) const { return run(command + " --help").out; }

  /// The options of a command: "-o", "--output", ...
  Words options(const std::string& command) const { return matches(help(command), "^  (-[-a-z,]+)"); }

  /// The words that options of a command take.
  Words choices(const std::string& command) const { return matches(help(command), "\\{([-a-z,]+)\\}"); }

  /// The part of the manual about a command.
  std::string section(const std::string& command) const {
    const std::string heading = ".Ss circle-voronoi " + command + "\n";
    const std::size_t begin = manual_.find(heading);
    EXPECT_NE(begin, std::string::npos) << heading;
    const std::size_t end = std::min(manual_.find("\n.Ss ", begin), manual_.find("\n.Sh ", begin));
    return begin == std::string::npos ? "" : manual_.substr(begin, end - begin);
  }

  /// The completions that bash offers for the last of some words.
  Words completions(const std::string& words) const {
    const std::string script =
        write("complete.sh", "source '" CIRCLE_VORONOI_PROGRAM_SOURCES
                             "/circle-voronoi.bash'\n"
                             "[[ $(complete -p circle-voronoi) == *' -F _circle_voronoi '* ]] || exit 1\n"
                             "COMP_WORDS=('" +
                                 program_ + "' " + words +
                                 ")\n"
                                 "COMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n"
                                 "_circle_voronoi\n"
                                 "echo \"${COMPREPLY[@]}\"\n");
    const auto [status, out, err] = shell("bash " + script);
    EXPECT_EQ(status, 0);
    EXPECT_EQ(err, "");
    return wordsOf(out);
  }
};

TEST_F(CliDocumentation, TheManualHasTheOptionsOfEveryCommand) {
  for (const std::string& command : kCommands) {
    Words described;
    for (const std::string& line : test::linesOf(section(command))) {
      if (!line.starts_with(".It Fl ")) continue;
      const Words words = wordsOf(std::regex_replace(line.substr(7), std::regex("Ar.*"), ""));
      for (const std::string& word : words) {
        if (word != ",") described.insert("-" + word);
      }
    }
    EXPECT_EQ(described, options(command)) << command;
    EXPECT_FALSE(described.empty());
  }
}

TEST_F(CliDocumentation, TheManualHasTheWordsThatOptionsTake) {
  const Words described = matches(manual_, "^\\.(?:It )?Cm ([-a-z]+)");
  for (const std::string& command : kCommands) {
    for (const std::string& choice : choices(command)) EXPECT_TRUE(described.contains(choice)) << choice;
  }
  EXPECT_TRUE(choices("compute").contains("geojson"));
}

TEST_F(CliDocumentation, HelpExplainsEveryFormat) {
  const std::string text = help("compute");
  const Words explained = matches(text.substr(text.find("Formats:")), "^  ([a-z]+)  ");
  EXPECT_EQ(explained, completions("compute --format ''"));
}

TEST_F(CliDocumentation, TheManualAndHelpHaveTheSameExitStatuses) {
  const std::string text = run("--help").out;
  std::vector<std::string> explained;
  for (const std::string& line : test::linesOf(text.substr(text.find("Exit status:")))) {
    if (line.starts_with("  ")) explained.push_back(line.substr(2));
  }
  std::vector<std::string> described;
  std::istringstream manual(manual_.substr(manual_.find(".Sh EXIT STATUS")));
  for (std::string line; std::getline(manual, line) && line != ".El";) {
    if (line.starts_with(".It ")) {
      described.push_back(line.substr(4) + " ");
    } else if (!described.empty()) {
      described.back() += " " + line;
    }
  }
  EXPECT_EQ(described, explained);
  EXPECT_EQ(described.size(), 4U);
}

TEST_F(CliDocumentation, BashCompletesCommands) {
  EXPECT_EQ(completions("''"), Words(kCommands.begin(), kCommands.end()));
  EXPECT_EQ(completions("co"), (Words{"compute", "convert"}));
  EXPECT_EQ(completions("--"), (Words{"--help", "--version"}));
}

TEST_F(CliDocumentation, BashCompletesOptions) {
  for (const std::string& command : kCommands) EXPECT_EQ(completions(command + " -"), options(command));
  EXPECT_EQ(completions("compute circles.csv --sa"), Words{"--samples"});
}

TEST_F(CliDocumentation, BashCompletesWhatOptionsTake) {
  EXPECT_EQ(completions("compute circles.csv --method ''"), (Words{"auto", "flip", "touching-disc"}));
  EXPECT_EQ(completions("convert --format s"), (Words{"stats", "svg"}));
  EXPECT_EQ(completions("convert --format = s"), (Words{"stats", "svg"})) << "bash takes --format=s apart";
  EXPECT_EQ(completions("convert --format ="), completions("convert --format ''"));
  EXPECT_EQ(completions("compute --output ''"), Words{}) << "bash offers files then";
}

TEST_F(CliDocumentation, BashCompletesFamilies) {
  Words names;
  for (const FamilyInfo& family : families()) names.insert(std::string(family.name));
  EXPECT_EQ(completions("generate ''"), names);
  EXPECT_EQ(completions("generate log-uniform ''"), Words{});
}

}  // namespace
}  // namespace circle_voronoi
