// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace circle_voronoi::test {

namespace {

/// The program as built, or the one in WebAssembly (tests/wasm/program.test.mjs).
std::string chosenProgram() {
  const char* const other = std::getenv("CIRCLE_VORONOI_PROGRAM");
  return other != nullptr ? other : CIRCLE_VORONOI_PROGRAM;
}

}  // namespace

const std::string Cli::program_ = chosenProgram();

Cli::Cli() : folder_(std::filesystem::temp_directory_path() / ("circle-voronoi-test-" + std::to_string(getpid()))) {
  std::filesystem::create_directories(folder_);
}

Cli::~Cli() { std::filesystem::remove_all(folder_); }

std::string Cli::write(const std::string& name, const std::string& text) const {
  std::ofstream(path(name)) << text;
  return path(name);
}

std::string Cli::readFile(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

Outcome Cli::shell(const std::string& command, const std::string& input) const {
  const std::string in = write("stdin", input);
  const std::string whole = "( " + command + " ) <" + in + " >" + path("stdout") + " 2>" + path("stderr");
  const int code = std::system(whole.c_str());
  return {WIFEXITED(code) ? WEXITSTATUS(code) : -1, readFile(path("stdout")), readFile(path("stderr"))};
}

Outcome Cli::run(const std::string& arguments, const std::string& input) const {
  return shell(program_ + " " + arguments, input);
}

void Cli::expectFailure(const Outcome& run, int status, const std::string& message) {
  EXPECT_EQ(run.status, status) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(std::ranges::count(run.err, '\n'), 1) << run.err;
  EXPECT_NE(run.err.find(message), std::string::npos) << run.err;
}

}  // namespace circle_voronoi::test
