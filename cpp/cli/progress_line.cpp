// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress_line.h"

#include <unistd.h>

#include <cmath>
#include <iostream>

namespace circle_voronoi::cli {
namespace {

constexpr std::chrono::milliseconds kDelay{1000};
constexpr std::chrono::milliseconds kPeriod{100};

}  // namespace

void addProgressOption(CLI::App& command, std::string& when) {
  command
      .add_option("--progress", when,
                  "Show on standard error how far the work is; auto: on a terminal, if it takes more than a second")
      ->type_name("WHEN")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->capture_default_str();
}

ProgressLine::ProgressLine(const std::string& when) {
  if (when == "never" || (when == "auto" && isatty(STDERR_FILENO) == 0)) return;
  if (when == "auto") delay_ = kDelay;
  refresher_ = std::thread([this] { refresh(); });
}

void ProgressLine::show(std::string_view stage, double done) {
  if (!refresher_.joinable()) return;
  const std::lock_guard lock(mutex_);
  const bool isNew = stage_ != stage;
  stage_ = stage;
  done_ = done;
  if (isNew) write();
}

void ProgressLine::end() {
  if (!refresher_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    isEnding_ = true;
  }
  ended_.notify_one();
  refresher_.join();
  replaceLine("");
}

void ProgressLine::refresh() {
  std::unique_lock lock(mutex_);
  while (!ended_.wait_for(lock, kPeriod, [this] { return isEnding_; })) write();
}

void ProgressLine::write() {
  const auto elapsed = Clock::now() - begin_;
  if (stage_.empty() || elapsed < delay_) return;
  std::string line = stage_;
  if (done_ > 0) line += " " + std::to_string(std::lround(100 * done_)) + " %";
  replaceLine(line + ", " + std::to_string(std::chrono::duration_cast<std::chrono::seconds>(elapsed).count()) + " s");
}

void ProgressLine::replaceLine(const std::string& line) {
  const auto blank = [&] { return "\r" + std::string(width_, ' ') + "\r"; };
  if (width_ > 0) std::cerr << blank();
  std::cerr << line << std::flush;
  width_ = line.size();
}

}  // namespace circle_voronoi::cli
