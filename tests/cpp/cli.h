// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace circle_voronoi::test {

/// The exit status and the output of a program.
struct Outcome {
  int status = -1;
  std::string out;
  std::string err;
};

/// Runs the program circle-voronoi as a user does, with a folder of its own for files.
class Cli : public testing::Test {
 protected:
  Cli();
  ~Cli() override;

  /// The program as built, or that of the environment variable CIRCLE_VORONOI_PROGRAM.
  static const std::string program_;

  /// A file in the folder.
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// Writes a file in the folder and returns its path.
  std::string write(const std::string& name, const std::string& text) const;

  static std::string readFile(const std::string& file);

  /// Runs a command of the shell, with some text as its standard input.
  Outcome shell(const std::string& command, const std::string& input = "") const;

  /// Runs the program with arguments as in a shell, and with some text as its standard input.
  Outcome run(const std::string& arguments, const std::string& input = "") const;

  /// Runs the program, expects success and the text `said` on standard error, and returns its output.
  std::string textOf(const std::string& arguments, const std::string& input = "", const std::string& said = "") const;

  /// Expects that the program wrote nothing but one line on standard error.
  static void expectFailure(const Outcome& run, int status, const std::string& message);

 private:
  std::filesystem::path folder_;
};

/// The target of a program's standard error.
enum class Said { toTerminal, toPipe };

/// A program that runs until it gets its standard input, which is when the test says, however long it takes to start.
class WaitingProgram {
 public:
  /// Starts the program that the first word names.
  WaitingProgram(std::vector<std::string> words, Said said);
  WaitingProgram(const WaitingProgram&) = delete;
  WaitingProgram& operator=(const WaitingProgram&) = delete;
  ~WaitingProgram();

  /// Waits until the program has said something. Returns false if it ends without that, or hangs.
  bool says(const std::string& pattern);

  /// Passes the input to the program, expects success, and returns the whole output.
  std::string end(const std::string& input);

  /// Sends a signal to the program, and returns its status once it has ended.
  int kill(int signal);

 private:
  bool readMore();
  int waited();

  pid_t child_ = -1;
  int input_ = -1;
  int said_ = -1;
  std::string text_;
};

}  // namespace circle_voronoi::test
