// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace circle_voronoi::test {

/// How a program ended, and what it wrote.
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

  /// A failure says one line and writes nothing.
  static void expectFailure(const Outcome& run, int status, const std::string& message);

 private:
  std::filesystem::path folder_;
};

}  // namespace circle_voronoi::test
