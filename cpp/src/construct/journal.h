// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/diagram.h"
#include "circle_voronoi/progress.h"
#include "stopwatch.h"

namespace circle_voronoi {

/// What a computation notes as it goes: its statistics and, for who listens, where it is.
class Journal {
 public:
  /// `progress` must outlive the journal.
  explicit Journal(const Progress& progress) : progress_(progress) {}

  Stats stats;

  /// Tells that a stage begins; the time until the end of what is returned is the stage's.
  [[nodiscard]] Stopwatch enter(Stage stage) {
    tell(stage, 0);
    return Stopwatch(secondsOf(stage));
  }

  void tell(Stage stage, double done) const {
    if (progress_) progress_(stage, done);
  }

 private:
  double& secondsOf(Stage stage);

  const Progress& progress_;
};

}  // namespace circle_voronoi
