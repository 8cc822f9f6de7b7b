// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace circle_voronoi::cli {

/// The text that a progress line writes to a terminal. The text depends only on the arguments, including the time, so
/// that tests need no clock. web/cli/progress-line.ts is the same in JavaScript.
class ProgressText {
 public:
  using Elapsed = std::chrono::milliseconds;

  /// Delay before the line is shown, unless it was requested.
  static constexpr Elapsed kDelay{1000};

  /// Returns the delay before the line first appears, or nothing if it never appears. `when` is `auto`, `always` or
  /// `never`.
  static std::optional<Elapsed> delayOf(std::string_view when, bool isTerminal) {
    if (when == "never" || (when == "auto" && !isTerminal)) return std::nullopt;
    return when == "auto" ? kDelay : Elapsed{0};
  }

  explicit ProgressText(Elapsed delay) : delay_(delay) {}

  // Each returns the text to write. `elapsed` is the time since the line began.

  /// Returns the text after a report of a stage. `done` is the finished part of the stage, or 0 if unknown.
  std::string show(std::string_view stage, double done, Elapsed elapsed) {
    const auto percent = done > 0 ? std::optional(std::lround(100 * done)) : std::nullopt;
    if (stage == stage_ && percent == percent_) return "";
    stage_ = stage;
    percent_ = percent;
    return refresh(elapsed);
  }

  /// Returns the text after some time without a report.
  std::string refresh(Elapsed elapsed) {
    if (stage_.empty() || elapsed < delay_) return "";
    const std::string part = percent_ ? " " + std::to_string(*percent_) + " %" : "";
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(elapsed).count();
    return replaced(stage_ + part + ", " + std::to_string(seconds) + " s");
  }

  /// Erases the line.
  std::string end() { return replaced(""); }

 private:
  std::string replaced(const std::string& line) {
    if (line == line_) return "";
    const std::string blank = line_.empty() ? "" : "\r" + std::string(line_.size(), ' ') + "\r";
    line_ = line;
    return blank + line;
  }

  Elapsed delay_;  ///< the delay before the line is first shown
  std::string stage_;
  std::optional<long> percent_;
  std::string line_;  ///< the line on the screen
};

}  // namespace circle_voronoi::cli
