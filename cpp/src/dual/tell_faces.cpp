// SPDX-License-Identifier: GPL-3.0-or-later
#include "tell_faces.h"

#include <algorithm>
#include <limits>

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

FaceTeller::FaceTeller(const Dual& dual, const std::vector<Circle>& circles, const Observer& observer)
    : dual_(dual), circles_(circles), observer_(observer), predicates_(circles) {}

FaceTeller::~FaceTeller() = default;

void FaceTeller::tellEvent(TraceKind kind, const Vertex& disc, int a, int b, int c, int number) const {
  observer_({kind, disc, {a, b, c}, kNone, {number, kNone}});
}

void FaceTeller::tellRound(int round) const {
  if (observer_) tellEvent(TraceKind::roundBegun, {}, kNone, kNone, kNone, round);
}

void FaceTeller::tellCircle(TraceKind kind, int i, const Circle& circle) const {
  tellEvent(kind, {circle.x, circle.y, circle.r}, i, kNone, kNone);
}

void FaceTeller::willChange(int face) {
  tell();
  lookAt(face);
}

void FaceTeller::tellChanges() {
  if (!observer_) return;
  for (int face = 0; face < dual_.faceCount(); ++face) lookAt(face);
  tell();
}

void FaceTeller::know() {
  if (!observer_) return;
  told_.resize(static_cast<std::size_t>(dual_.faceCount()));
  for (int face = 0; face < dual_.faceCount(); ++face) told_[face] = faceAt(face);
}

void FaceTeller::tell() {
  predicates_.setCircles(circles_);
  if (told_.size() < static_cast<std::size_t>(dual_.faceCount())) told_.resize(dual_.origin.size() / 3);
  sortUnique(looked_);
  const auto changed = std::remove_if(looked_.begin(), looked_.end(), [&](int face) { return !isChanged(face); });
  if (changed == looked_.begin()) return;  // all are still to change
  looked_.erase(changed, looked_.end());
  if (looked_.size() == 2) tellReason(looked_[0], looked_[1]);
  for (const int face : looked_) {
    const auto& [corners, disc] = told_[face];
    if (told_[face].isThere()) tellEvent(TraceKind::faceRemoved, disc, corners[0], corners[1], corners[2], face);
  }
  for (const int face : looked_) {
    told_[face] = faceAt(face);
    const auto& [corners, disc] = told_[face];
    if (told_[face].isThere()) tellEvent(TraceKind::faceMade, disc, corners[0], corners[1], corners[2], face);
  }
  looked_.clear();
}

FaceTeller::Face FaceTeller::faceAt(int face) {
  Face result;
  if (dual_.twin[3 * face] == kNone) return result;
  int first = 0;
  const auto corners = cornersOf(dual_, 3 * face);
  // Start with the corner after infinity or, if there is none, with the smallest corner.
  for (int k = 0; k < 3; ++k) {
    if (corners[k] == kPointAtInfinity) {
      first = (k + 1) % 3;
      break;
    }
    if (corners[k] < corners[first]) first = k;
  }
  const int a = corners[first];
  const int b = corners[(first + 1) % 3];
  const int c = corners[(first + 2) % 3];
  result.corners = {a, b, c};
  result.disc = kNoDisc;
  if (hasDisc(result.corners)) result.disc = vertexOf(circles_[a], circles_[b], circles_[c]).value_or(kNoDisc);
  return result;
}

bool FaceTeller::hasDisc(const std::array<int, 3>& corners) {
  for (int k = 0; k < 3; ++k) {
    if (corners[k] == kPointAtInfinity || corners[k] == shrinking_) return false;
    for (int other = 0; other < 3; ++other) {
      if (other == k || corners[other] == kPointAtInfinity) continue;
      if (predicates_.contains(circles_[corners[k]], circles_[corners[other]])) return false;
    }
  }
  return predicates_.disc(corners).exists;
}

bool FaceTeller::isChanged(int face) {
  const Face now = faceAt(face);
  const Face& told = told_[face];
  if (now.corners != told.corners) return true;
  if (shrinking_ != kPointAtInfinity && now.has(shrinking_)) return false;
  return now.hasDisc() ? now.disc != told.disc : told.hasDisc() && now.isThere();
}

/// Tells why two faces are replaced by two others: their common edge is flipped.
void FaceTeller::tellReason(int f, int g) {
  const Face& first = told_[f];
  const Face& second = told_[g];
  const Face made = faceAt(f);
  const Face other = faceAt(g);
  if (!first.isThere() || !second.isThere()) return;
  for (int i = 0; i < 9; ++i) {
    const int a = first.corners[i / 3];
    const int b = first.corners[(i / 3 + 1) % 3];
    const int c = first.corners[(i / 3 + 2) % 3];
    const int d = second.corners[(i + 2) % 3];
    const bool isEdge = second.corners[i % 3] == b && second.corners[(i + 1) % 3] == a;
    if (!isEdge || !made.has(c) || !made.has(d) || !other.has(c) || !other.has(d)) continue;
    if (shrinking_ != kPointAtInfinity && (a == shrinking_ || b == shrinking_)) {
      const Circle& circle = circles_[shrinking_];
      const Face& whole = made.has(shrinking_) ? other : made;
      const Vertex shrunk = {circle.x, circle.y, circle.r - depth(whole.disc, circle)};
      if (whole.hasDisc()) tellEvent(TraceKind::circleShrunk, shrunk, shrinking_, kNone, kNone);
    } else if (a == kPointAtInfinity || b == kPointAtInfinity) {
      tellEvent(TraceKind::hullNotConvex, kNoDisc, std::max(a, b), c, d);
    } else if (c == kPointAtInfinity || d == kPointAtInfinity) {
      tellEvent(TraceKind::tangentNotClear, kNoDisc, a, b, std::max(c, d));
    } else {
      // The disc that reaches farther over the rim of the circle opposite. No disc does if a flip is reverted.
      const bool isFirst =
          !second.hasDisc() || (first.hasDisc() && depth(first.disc, circles_[d]) >= depth(second.disc, circles_[c]));
      const Vertex& disc = isFirst ? first.disc : second.disc;
      const int met = isFirst ? d : c;
      if (meets(disc, circles_[met])) {
        tellEvent(TraceKind::discNotEmpty, disc, a, b, met);
      } else if (!first.hasDisc() || !second.hasDisc()) {
        tellEvent(TraceKind::discMissing, kNoDisc, a, b, first.hasDisc() ? d : c);
      }
    }
    return;
  }
}

}  // namespace circle_voronoi
