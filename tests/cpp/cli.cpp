// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli.h"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace circle_voronoi::test {

namespace {

/// The native program, or the program in WebAssembly (tests/wasm/program.test.mjs).
std::string chosenProgram() {
  const char* const other = std::getenv("CIRCLE_VORONOI_PROGRAM");
  return other != nullptr ? other : CIRCLE_VORONOI_PROGRAM;
}

}  // namespace

const std::string Cli::program_ = chosenProgram();

Cli::Cli() : folder_(std::filesystem::temp_directory_path() / ("circle-voronoi-test-" + std::to_string(getpid()))) {
  // One that was killed may have left files, and numbers of processes come again.
  std::filesystem::remove_all(folder_);
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

std::string Cli::textOf(const std::string& arguments, const std::string& input, const std::string& said) const {
  const auto [status, out, err] = run(arguments, input);
  EXPECT_EQ(status, 0) << err;
  EXPECT_EQ(err, said);
  return out;
}

void Cli::expectFailure(const Outcome& run, int status, const std::string& message) {
  EXPECT_EQ(run.status, status) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(std::ranges::count(run.err, '\n'), 1) << run.err;
  EXPECT_NE(run.err.find(message), std::string::npos) << run.err;
}

namespace {

/// A pipe that other programs do not hold open.
std::array<int, 2> newPipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("There is no pipe.");
  return ends;
}

}  // namespace

WaitingProgram::WaitingProgram(std::vector<std::string> words, Said said) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const auto [inputOfChild, input] = newPipe();
  const auto [saidHere, saidByChild] = newPipe();
  int terminal = -1;
  child_ = said == Said::toTerminal ? forkpty(&terminal, nullptr, nullptr, nullptr) : fork();
  if (child_ == 0) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::signal(signal, SIG_DFL);
    dup2(inputOfChild, STDIN_FILENO);
    if (said == Said::toPipe) dup2(saidByChild, STDERR_FILENO);
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  close(inputOfChild);
  close(saidByChild);
  input_ = input;
  said_ = saidHere;
  if (said == Said::toTerminal) {
    close(saidHere);
    said_ = terminal;
    fcntl(said_, F_SETFD, FD_CLOEXEC);
  }
}

WaitingProgram::~WaitingProgram() {
  if (child_ != -1) kill(SIGKILL);
  if (input_ != -1) close(input_);
  close(said_);
}

bool WaitingProgram::says(const std::string& pattern) {
  const std::regex regex(pattern);
  while (!std::regex_search(text_, regex)) {
    if (!readMore()) return false;
  }
  return true;
}

std::string WaitingProgram::end(const std::string& input) {
  EXPECT_EQ(write(input_, input.data(), input.size()), static_cast<ssize_t>(input.size()));
  close(std::exchange(input_, -1));
  while (readMore()) continue;
  const int status = waited();
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << text_;
  return text_;
}

int WaitingProgram::kill(int signal) {
  ::kill(child_, signal);
  return waited();
}

bool WaitingProgram::readMore() {
  constexpr int kHangs = 100'000;  // milliseconds
  pollfd ready{said_, POLLIN, 0};
  if (poll(&ready, 1, kHangs) != 1) return false;
  std::array<char, 1024> part{};
  const ssize_t size = read(said_, part.data(), part.size());
  if (size > 0) text_.append(part.data(), static_cast<std::size_t>(size));
  return size > 0;  // below 0 where the last program of a terminal has ended
}

int WaitingProgram::waited() {
  int status = 0;
  waitpid(std::exchange(child_, -1), &status, 0);
  return status;
}

}  // namespace circle_voronoi::test
