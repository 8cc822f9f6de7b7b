// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <string_view>

namespace circle_voronoi::cli {

/// Adds `--progress` to a command; `when` becomes the value that the user gives.
void addProgressOption(CLI::App& command, std::string& when);

/// A progress line on standard error with the stage and the elapsed time (progress_text.h). It is rewritten in place
/// and erased in the end. `when`: `auto` shows it for work over a second if standard error is a terminal, `always` at
/// once, `never` not at all. It has its own thread, so that the time advances during a stage without progress.
class ProgressLine {
 public:
  explicit ProgressLine(const std::string& when);
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  /// Shows the current stage. `done` is the finished part of the stage, 0 to 1, or 0 if unknown.
  void show(std::string_view stage, double done = 0);

  /// Erases the line for good.
  void end();

 private:
  class Shown;
  std::unique_ptr<Shown> shown_;  ///< null if the line is not shown, or no longer
};

}  // namespace circle_voronoi::cli
