// SPDX-License-Identifier: GPL-3.0-or-later
// The line on standard error that says how far the work is. progress_text_test.cpp has it at given times.
#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

#include "cli.h"
#include "fixtures.h"

namespace circle_voronoi {
namespace {

class CliProgress : public test::Cli {
 protected:
  const std::string fixture_ = test::pathOfFixture("spruces");

  std::string quick(const std::string& options) const {
    return program_ + " compute " + fixture_ + " -o " + path("out.json") + options;
  }
};

/// The contents of a terminal after `text`: each carriage return begins the line again.
std::string shown(const std::string& text) {
  std::string line;
  std::size_t at = 0;
  for (const char c : text) {
    if (c == '\r') {
      at = 0;
    } else {
      line.resize(std::max(line.size(), at + 1), ' ');
      line[at++] = c;
    }
  }
  return line.substr(0, line.find_last_not_of(' ') + 1);
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_F(CliProgress, IsShownOnATerminalForWorkOverASecondAndNotElsewhere) {
  using enum test::Said;
  const std::vector<std::string> compute = {program_, "compute", "-", "-o", "/dev/null"};
  const std::vector<std::string> quietly = {program_, "compute", "-", "-o", "/dev/null", "--progress", "never"};
  test::WaitingProgram never(quietly, toTerminal);
  test::WaitingProgram unseen(compute, toPipe);
  test::WaitingProgram seen(compute, toTerminal);
  // All programs wait for their circles until the one that began last shows that it has waited for over a second.
  EXPECT_TRUE(seen.says("read, [1-9]"));
  const std::string circles = readFile(fixture_);
  EXPECT_EQ(never.end(circles), "");
  EXPECT_EQ(unseen.end(circles), "");
  const std::string text = seen.end(circles);
  EXPECT_FALSE(has(text, "read, 0 s")) << text;
  EXPECT_EQ(shown(text), "");
}

TEST_F(CliProgress, SaysEachStageWhereItIsAskedFor) {
  const std::string text = shell(quick(" --progress always")).err;
  for (const char* stage : {"read", "order", "triangulate", "flip", "certify", "assemble", "write"}) {
    EXPECT_TRUE(std::regex_search(text, std::regex(std::string(stage) + ", \\d+ s"))) << stage << " in " << text;
  }
  EXPECT_EQ(shown(text), "");
  expectFailure(run("compute - --progress often"), 2, "--progress");
}

TEST_F(CliProgress, TellsThePartOfTheEventLoopThatIsDone) {
  const std::string text =
      shell(program_ + " generate uniform 1500 | " + program_ +
            " compute - --method touching-disc --candidates all-pairs --progress always -o " + path("out.json"))
          .err;
  EXPECT_TRUE(std::regex_search(text, std::regex("touch 50 %, \\d+ s"))) << text;
  EXPECT_EQ(shown(text), "");
}

TEST_F(CliProgress, LeavesOneLineForAnError) {
  const auto [status, out, err] = run("compute - --progress always", "1,2\n");
  EXPECT_EQ(status, 2);
  EXPECT_EQ(shown(err), run("compute -", "1,2\n").err);
}

TEST_F(CliProgress, EndsBeforeStandardOutputBegins) {
  const auto [status, out, err] = shell(program_ + " compute " + fixture_ + " --progress always 2>&1");
  EXPECT_EQ(status, 0);
  const std::size_t begin = out.find("{\"format\"");
  ASSERT_NE(begin, std::string::npos);
  EXPECT_EQ(shown(out.substr(0, begin)), "");
  EXPECT_FALSE(has(out.substr(begin), "\r"));
}

TEST_F(CliProgress, IsShownForConvertAndCertify) {
  ASSERT_EQ(shell(quick("")).status, 0);
  EXPECT_TRUE(has(run("certify --progress always " + path("out.json")).err, "certify, "));
  EXPECT_TRUE(has(run("convert --progress always " + path("out.json") + " -o " + path("out.svg")).err, "certify, "));
}

TEST_F(CliProgress, IsShownForBoxesTilesAndEdits) {
  const std::string options = " --progress always -o " + path("out.json");
  const std::string periodic = run("compute " + fixture_ + " --lattice 99,0,0,99" + options).err;
  const std::string tile =
      run("compute " + fixture_ + " --known=-inf,-inf,inf,inf --max-radius 0 --format csv" + options).err;
  for (const char* stage : {"read", "triangulate", "flip", "certify", "write"}) {
    EXPECT_TRUE(has(periodic, std::string(stage) + ", ")) << stage << " in " << periodic;
    EXPECT_TRUE(has(tile, std::string(stage) + ", ")) << stage << " in " << tile;
  }
  const std::string script = write("edits.csv", "remove,0\nremove,1\nremove,2\nremove,3\n");
  const std::string edits = run("edit " + fixture_ + " --script " + script + options).err;
  for (const char* part : {"read, ", "compute, ", "edit, ", "edit 25 %, ", "edit 50 %, ", "edit 75 %, ", "write, "}) {
    EXPECT_TRUE(has(edits, part)) << part << " in " << edits;
  }
  const std::string cut = run("tile " + fixture_ + " --size 10 --halo 1 --progress always -o " + path("tiles")).err;
  for (const char* part : {"cut, ", "cut 100 %, ", "write, "}) EXPECT_TRUE(has(cut, part)) << part << " in " << cut;
}

}  // namespace
}  // namespace circle_voronoi
