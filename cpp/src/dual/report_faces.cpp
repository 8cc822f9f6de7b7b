// SPDX-License-Identifier: GPL-3.0-or-later
#include "report_faces.h"

#include <algorithm>
#include <limits>

#include "at.h"
#include "sort_unique.h"
#include "three_touch_disc.h"

namespace circle_voronoi {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr Vertex kNoDisc = {kNaN, kNaN, kNaN};

/// Returns how far a disc reaches into a circle.
double depth(const Vertex& disc, const Circle& circle) {
  return circle.r + disc.r - length({circle.x - disc.x, circle.y - disc.y});
}

/// Returns whether a disc meets a circle or touches it up to rounding.
bool meets(const Vertex& disc, const Circle& circle) {
  const double size = std::abs(circle.x) + std::abs(circle.y) + std::abs(circle.r) + std::abs(disc.x) +
                      std::abs(disc.y) + std::abs(disc.r);
  return depth(disc, circle) >= -0x1p-30 * size;
}

}  // namespace

FaceReporter::FaceReporter(const Dual& dual, const std::vector<Circle>& circles, const Observer& observer)
    : dual_(dual), circles_(circles), observer_(observer), predicates_(circles) {}

FaceReporter::~FaceReporter() = default;

void FaceReporter::reportEvent(TraceKind kind, const Vertex& disc, int a, int b, int c, int number) const {
  observer_({kind, disc, {a, b, c}, kNone, {number, kNone}});
}

void FaceReporter::reportRound(int round) const {
  if (observer_) reportEvent(TraceKind::roundBegun, {}, kNone, kNone, kNone, round);
}

void FaceReporter::reportCircle(TraceKind kind, int i, const Circle& circle) const {
  reportEvent(kind, {circle.x, circle.y, circle.r}, i, kNone, kNone);
}

void FaceReporter::willChange(int face) {
  reportPending();
  addPending(face);
}

void FaceReporter::reportChanges() {
  if (!observer_) return;
  for (int face = 0; face < dual_.faceCount(); ++face) addPending(face);
  reportPending();
}

void FaceReporter::markReported() {
  if (!observer_) return;
  reported_.resize(static_cast<std::size_t>(dual_.faceCount()));
  for (int face = 0; face < dual_.faceCount(); ++face) reported_[at(face)] = faceAt(face);
}

void FaceReporter::reportPending() {
  predicates_.setCircles(circles_);
  if (reported_.size() < static_cast<std::size_t>(dual_.faceCount())) reported_.resize(dual_.origin.size() / 3);
  sortUnique(pending_);
  const auto changed = std::remove_if(pending_.begin(), pending_.end(), [&](int face) { return !isChanged(face); });
  if (changed == pending_.begin()) return;  // none has changed yet
  pending_.erase(changed, pending_.end());
  if (pending_.size() == 2) reportReason(pending_[0], pending_[1]);
  for (const int face : pending_) {
    const auto& [corners, disc] = reported_[at(face)];
    if (reported_[at(face)].isThere())
      reportEvent(TraceKind::faceRemoved, disc, corners[0], corners[1], corners[2], face);
  }
  for (const int face : pending_) {
    reported_[at(face)] = faceAt(face);
    const auto& [corners, disc] = reported_[at(face)];
    if (reported_[at(face)].isThere()) reportEvent(TraceKind::faceMade, disc, corners[0], corners[1], corners[2], face);
  }
  pending_.clear();
}

FaceReporter::Face FaceReporter::faceAt(int face) {
  Face result;
  if (dual_.twin[at(3 * face)] == kNone) return result;
  int first = 0;
  const auto corners = cornersOf(dual_, 3 * face);
  // Start with the corner after infinity or, if there is none, with the smallest corner.
  for (int k = 0; k < 3; ++k) {
    if (corners[at(k)] == kPointAtInfinity) {
      first = (k + 1) % 3;
      break;
    }
    if (corners[at(k)] < corners[at(first)]) first = k;
  }
  const int a = corners[at(first)];
  const int b = corners[at((first + 1) % 3)];
  const int c = corners[at((first + 2) % 3)];
  result.corners = {a, b, c};
  result.disc = kNoDisc;
  if (hasDisc(result.corners))
    result.disc = vertexOf(circles_[at(a)], circles_[at(b)], circles_[at(c)]).value_or(kNoDisc);
  return result;
}

bool FaceReporter::hasDisc(const std::array<int, 3>& corners) {
  for (int k = 0; k < 3; ++k) {
    if (corners[at(k)] == kPointAtInfinity || corners[at(k)] == shrinking_) return false;
    for (int other = 0; other < 3; ++other) {
      if (other == k || corners[at(other)] == kPointAtInfinity) continue;
      if (predicates_.contains(circles_[at(corners[at(k)])], circles_[at(corners[at(other)])])) return false;
    }
  }
  return predicates_.disc(corners).exists;
}

bool FaceReporter::isChanged(int face) {
  const Face now = faceAt(face);
  const Face& reported = reported_[at(face)];
  if (now.corners != reported.corners) return true;
  if (shrinking_ != kPointAtInfinity && now.has(shrinking_)) return false;
  return now.hasDisc() ? now.disc != reported.disc : reported.hasDisc() && now.isThere();
}

/// Reports why two faces are replaced by two others: their common edge is flipped.
void FaceReporter::reportReason(int f, int g) {
  const Face& first = reported_[at(f)];
  const Face& second = reported_[at(g)];
  const Face made = faceAt(f);
  const Face other = faceAt(g);
  if (!first.isThere() || !second.isThere()) return;
  for (int i = 0; i < 9; ++i) {
    const int a = first.corners[at(i / 3)];
    const int b = first.corners[at((i / 3 + 1) % 3)];
    const int c = first.corners[at((i / 3 + 2) % 3)];
    const int d = second.corners[at((i + 2) % 3)];
    const bool isEdge = second.corners[at(i % 3)] == b && second.corners[at((i + 1) % 3)] == a;
    if (!isEdge || !made.has(c) || !made.has(d) || !other.has(c) || !other.has(d)) continue;
    if (shrinking_ != kPointAtInfinity && (a == shrinking_ || b == shrinking_)) {
      const Circle& circle = circles_[at(shrinking_)];
      const Face& whole = made.has(shrinking_) ? other : made;
      const Vertex shrunk = {circle.x, circle.y, circle.r - depth(whole.disc, circle)};
      if (whole.hasDisc()) reportEvent(TraceKind::circleShrunk, shrunk, shrinking_, kNone, kNone);
    } else if (a == kPointAtInfinity || b == kPointAtInfinity) {
      reportEvent(TraceKind::hullNotConvex, kNoDisc, std::max(a, b), c, d);
    } else if (c == kPointAtInfinity || d == kPointAtInfinity) {
      reportEvent(TraceKind::tangentNotClear, kNoDisc, a, b, std::max(c, d));
    } else {
      // The disc that reaches farther over the rim of the circle opposite. No disc does if a flip is reverted.
      const bool isFirst = !second.hasDisc() || (first.hasDisc() && depth(first.disc, circles_[at(d)]) >=
                                                                        depth(second.disc, circles_[at(c)]));
      const Vertex& disc = isFirst ? first.disc : second.disc;
      const int met = isFirst ? d : c;
      if (meets(disc, circles_[at(met)])) {
        reportEvent(TraceKind::discNotEmpty, disc, a, b, met);
      } else if (!first.hasDisc() || !second.hasDisc()) {
        reportEvent(TraceKind::discMissing, kNoDisc, a, b, first.hasDisc() ? d : c);
      }
    }
    return;
  }
}

}  // namespace circle_voronoi
