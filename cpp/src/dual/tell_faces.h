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

/// Tells an observer which faces of a dual a change removes and makes, and why. It compares the faces before and after
/// the change, so the code that changes the dual does not deal with events. Without an observer it does nothing.
class FaceTeller final : public FaceWatcher {
 public:
  /// The arguments must outlive this object. Events are by the indices and in the unit of `circles`.
  FaceTeller(const Dual& dual, const std::vector<Circle>& circles, const Observer& observer);
  ~FaceTeller() override;
  FaceTeller(const FaceTeller&) = delete;
  FaceTeller& operator=(const FaceTeller&) = delete;

  /// Itself if there is an observer.
  FaceTeller* watcher() { return observer_ ? this : nullptr; }

  /// Begins a round.
  void tellRound(int round) const;

  /// Reports the pending changes, and marks one more face to be compared later.
  void willChange(int face) override;

  /// One that may have changed.
  void lookAt(int face) { looked_.push_back(face); }

  /// Tells the changes of the faces that were looked at.
  void tell();

  /// Tells the changes among all faces. A face that was never told counts as new.
  void tellChanges();

  /// Takes all faces for told.
  void know();

  /// Tells that a circle comes, goes or becomes another.
  void tellCircle(TraceKind kind, int i, const Circle& circle) const;

  /// The circle that shrinks on its way out, or kPointAtInfinity. Faces that it gets then have no discs.
  void setShrinking(int circle) { shrinking_ = circle; }

 private:
  struct Face {
    /// The circle of lowest index first, infinity last; all at infinity: there is no such face.
    std::array<int, 3> corners = {kPointAtInfinity, kPointAtInfinity, kPointAtInfinity};
    Vertex disc;  ///< NaN: it has none

    bool isThere() const { return corners[0] != kPointAtInfinity; }
    bool has(int corner) const { return corners[0] == corner || corners[1] == corner || corners[2] == corner; }
    bool hasDisc() const { return !std::isnan(disc.r); }
  };

  Face faceAt(int face);
  bool hasDisc(const std::array<int, 3>& corners);
  bool isChanged(int face);
  void tellEvent(TraceKind kind, const Vertex& disc, int a, int b, int c, int number = kNone) const;
  void tellReason(int f, int g);

  const Dual& dual_;
  const std::vector<Circle>& circles_;
  const Observer& observer_;
  Predicates predicates_;
  std::vector<Face> told_;  ///< for each face its last event
  std::vector<int> looked_;
  int shrinking_ = kPointAtInfinity;
};

}  // namespace circle_voronoi
