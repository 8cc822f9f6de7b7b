// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress_line.h"

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <iostream>
#include <mutex>
#include <thread>

namespace circle_voronoi::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kDelay{1000};
constexpr std::chrono::milliseconds kPeriod{100};

}  // namespace

class ProgressLine::Shown {
 public:
  explicit Shown(Clock::duration delay) : delay_(delay), refresher_([this] { refresh(); }) {}
  Shown(const Shown&) = delete;
  Shown& operator=(const Shown&) = delete;

  ~Shown() {
    {
      const std::lock_guard lock(mutex_);
      isEnding_ = true;
    }
    ended_.notify_one();
    refresher_.join();
    replaceLine("");
  }

  void show(std::string_view stage, double done) {
    const std::lock_guard lock(mutex_);
    const bool isNew = stage_ != stage;
    stage_ = stage;
    done_ = done;
    if (isNew) write();
  }

 private:
  void refresh() {
    std::unique_lock lock(mutex_);
    while (!ended_.wait_for(lock, kPeriod, [this] { return isEnding_; })) write();
  }

  // Both with the mutex held.

  void write() {
    const auto elapsed = Clock::now() - begin_;
    if (stage_.empty() || elapsed < delay_) return;
    std::string line = stage_;
    if (done_ > 0) line += " " + std::to_string(std::lround(100 * done_)) + " %";
    replaceLine(line + ", " + std::to_string(std::chrono::duration_cast<std::chrono::seconds>(elapsed).count()) + " s");
  }

  void replaceLine(const std::string& line) {
    const auto blank = [&] { return "\r" + std::string(width_, ' ') + "\r"; };
    if (width_ > 0) std::cerr << blank();
    std::cerr << line << std::flush;
    width_ = line.size();
  }

  const Clock::time_point begin_ = Clock::now();
  const Clock::duration delay_;  ///< until it is first shown
  std::mutex mutex_;
  std::condition_variable ended_;
  bool isEnding_ = false;
  std::string stage_;
  double done_ = 0;
  std::size_t width_ = 0;  ///< of the line that is shown
  std::thread refresher_;
};

ProgressLine::ProgressLine(const std::string& when) {
  if (when == "never" || (when == "auto" && isatty(STDERR_FILENO) == 0)) return;
  shown_ = std::make_unique<Shown>(when == "auto" ? kDelay : Clock::duration{});
}

ProgressLine::~ProgressLine() = default;

void ProgressLine::show(std::string_view stage, double done) {
  if (shown_) shown_->show(stage, done);
}

void ProgressLine::end() { shown_.reset(); }

}  // namespace circle_voronoi::cli
