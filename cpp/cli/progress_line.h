// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <string_view>

namespace circle_voronoi::cli {

/// Adds `--progress` to a command; `when` becomes the value that the user gives.
void addProgressOption(CLI::App& command, std::string& when);

/// A line on standard error that says what is being done and since when (progress_text.h), rewritten in place and
/// erased in the end. `when`: `auto` shows it for work over a second if standard error is a terminal, `always` at once,
/// `never` not at all. It has a thread of its own, so that it goes on while a stage has nothing to tell.
class ProgressLine {
 public:
  explicit ProgressLine(const std::string& when);
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  /// The current stage and the part of it that is done: 0 to 1, and 0 if that is unknown.
  void show(std::string_view stage, double done = 0);

  /// Erases the line for good.
  void end();

 private:
  class Shown;
  std::unique_ptr<Shown> shown_;  ///< none if it is not shown, or no longer
};

}  // namespace circle_voronoi::cli
