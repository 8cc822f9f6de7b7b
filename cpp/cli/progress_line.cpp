// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress_line.h"

#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <iostream>
#include <mutex>
#include <thread>

#include "progress_text.h"

namespace circle_voronoi::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPeriod{100};

}  // namespace

class ProgressLine::Shown {
 public:
  explicit Shown(ProgressText::Elapsed delay) : text_(delay), refresher_([this] { refresh(); }) {}
  Shown(const Shown&) = delete;
  Shown& operator=(const Shown&) = delete;

  ~Shown() {
    {
      const std::lock_guard lock(mutex_);
      isEnding_ = true;
    }
    ended_.notify_one();
    refresher_.join();
    write(text_.end());
  }

  void show(std::string_view stage, double done) {
    const std::lock_guard lock(mutex_);
    write(text_.show(stage, done, elapsed()));
  }

 private:
  void refresh() {
    std::unique_lock lock(mutex_);
    while (!ended_.wait_for(lock, kPeriod, [this] { return isEnding_; })) write(text_.refresh(elapsed()));
  }

  ProgressText::Elapsed elapsed() const {
    return std::chrono::duration_cast<ProgressText::Elapsed>(Clock::now() - begin_);
  }

  static void write(const std::string& text) {
    if (!text.empty()) std::cerr << text << std::flush;
  }

  const Clock::time_point begin_ = Clock::now();
  std::mutex mutex_;
  std::condition_variable ended_;
  bool isEnding_ = false;
  ProgressText text_;
  std::thread refresher_;
};

ProgressLine::ProgressLine(const std::string& when) {
  if (const auto delay = ProgressText::delayOf(when, isatty(STDERR_FILENO) != 0)) {
    shown_ = std::make_unique<Shown>(*delay);
  }
}

ProgressLine::~ProgressLine() = default;

void ProgressLine::show(std::string_view stage, double done) {
  if (shown_) shown_->show(stage, done);
}

void ProgressLine::end() { shown_.reset(); }

}  // namespace circle_voronoi::cli
