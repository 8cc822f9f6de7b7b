// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "circle_voronoi/progress.h"
#include "circle_voronoi/stats.h"
#include "stopwatch.h"

namespace circle_voronoi {

/// Records the statistics of a computation, and reports its progress.
class Journal {
 public:
  /// `progress` must outlive the journal.
  explicit Journal(const Progress& progress) : progress_(progress) {}

  Stats stats;

  /// Begins a stage. The time until the end of the returned stopwatch counts as the stage's.
  [[nodiscard]] Stopwatch enter(Stage stage) {
    tell(stage, 0);
    return Stopwatch(stats.seconds.*kSecondsMembers[static_cast<std::size_t>(stage)].member);
  }

  void tell(Stage stage, double done) const {
    if (progress_) progress_(stage, done);
  }

 private:
  const Progress& progress_;
};

}  // namespace circle_voronoi
