// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "circle_voronoi/trace.h"
#include "dual.h"
#include "dual_keeper.h"
#include "predicates.h"

namespace circle_voronoi {

/// Reports to an observer which faces of a dual a change removes and makes, and why. It compares the faces before and
/// after the change, so the code that changes the dual does not deal with events. Without an observer it does nothing.
class FaceReporter final : public FaceWatcher {
 public:
  /// The arguments must outlive this object. Events are by the indices and in the unit of `circles`.
  FaceReporter(const Dual& dual, const std::vector<Circle>& circles, const Observer& observer);
  ~FaceReporter() override;
  FaceReporter(const FaceReporter&) = delete;
  FaceReporter& operator=(const FaceReporter&) = delete;

  /// Returns this object if there is an observer, otherwise null.
  FaceReporter* watcher() { return observer_ ? this : nullptr; }

  /// Begins a round.
  void reportRound(int round) const;

  /// Reports the pending changes, and marks one more face to be compared later.
  void willChange(int face) override;

  /// Marks a face as possibly changed.
  void addPending(int face) { pending_.push_back(face); }

  /// Reports the changes of the marked faces.
  void reportPending();

  /// Reports the changes among all faces. A face that was never reported counts as new.
  void reportChanges();

  /// Treats all current faces as reported.
  void markReported();

  /// Reports that a circle is inserted, removed or replaced.
  void reportCircle(TraceKind kind, int i, const Circle& circle) const;

  /// Sets the circle that is being removed by shrinking, or kPointAtInfinity. Its faces have no discs meanwhile.
  void setShrinking(int circle) { shrinking_ = circle; }

 private:
  struct Face {
    /// The circle of lowest index first, infinity last. Without such a face, all are infinity.
    std::array<int, 3> corners = {kPointAtInfinity, kPointAtInfinity, kPointAtInfinity};
    Vertex disc;  ///< NaN if there is none

    bool isThere() const { return corners[0] != kPointAtInfinity; }
    bool has(int corner) const { return corners[0] == corner || corners[1] == corner || corners[2] == corner; }
    bool hasDisc() const { return !std::isnan(disc.r); }
  };

  Face faceAt(int face);
  bool hasDisc(const std::array<int, 3>& corners);
  bool isChanged(int face);
  void reportEvent(TraceKind kind, const Vertex& disc, int a, int b, int c, int number = kNone) const;
  void reportReason(int f, int g);

  const Dual& dual_;
  const std::vector<Circle>& circles_;
  const Observer& observer_;
  Predicates predicates_;
  std::vector<Face> reported_;  ///< each face as last reported
  std::vector<int> pending_;
  int shrinking_ = kPointAtInfinity;
};

}  // namespace circle_voronoi
