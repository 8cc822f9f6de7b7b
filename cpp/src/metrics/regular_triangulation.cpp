// SPDX-License-Identifier: GPL-3.0-or-later
#include "regular_triangulation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>

#include "at.h"
#include "in_circle.h"
#include "judge_power.h"
#include "mix.h"
#include "settle_ties.h"
#include "vectors.h"

namespace circle_voronoi {
namespace {

/// Sites on a line, in the order of their places: those on the lower hull of the lifted ones, by a stack (A. M. Andrew,
/// 1979).
RegularTriangulation ofLine(std::span<const WeightedPoint> sites) {
  std::vector<int> order(sites.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  std::sort(order.begin(), order.end(), [&](int i, int j) { return isBefore(sites[at(i)].p, sites[at(j)].p); });
  RegularTriangulation result;
  std::vector<int> chain;
  for (const int site : order) {
    while (chain.size() > 1 &&
           powerTest(sites[at(chain[chain.size() - 2])], sites[at(site)], sites[at(chain.back())]) <= 0) {
      result.hidden.push_back(chain.back());
      chain.pop_back();
    }
    chain.push_back(site);
  }
  std::sort(result.hidden.begin(), result.hidden.end());
  // For each two neighbors a face on either side of their edge, with infinity as the third corner.
  Dual& dual = result.dual;
  const auto edgeCount = static_cast<int>(chain.size()) - 1;
  for (int k = 0; k < edgeCount; ++k) {
    dual.origin.insert(dual.origin.end(), {chain[at(k)], chain[at(k + 1)], kPointAtInfinity, chain[at(k + 1)],
                                           chain[at(k)], kPointAtInfinity});
  }
  dual.twin.resize(dual.origin.size());
  for (int k = 0; k < edgeCount; ++k) {
    const int forth = 6 * k;
    const int back = forth + 3;
    dual.link(forth, back);
    if (k + 1 < edgeCount) {
      dual.link(forth + 1, forth + 8);
      dual.link(back + 2, back + 7);
    }
  }
  if (edgeCount > 0) {
    dual.link(4, 2);
    dual.link(6 * edgeCount - 5, 6 * edgeCount - 1);
  }
  return result;
}

class Triangulator {
 public:
  /// Begins with three sites, counter-clockwise.
  Triangulator(std::span<const WeightedPoint> sites, const std::array<int, 3>& first)
      : sites_(sites), faceAt_(sites.size() + 1, kNone), isHidden_(sites.size(), false) {
    const auto [a, b, c] = first;
    dual_.origin = {a, b, c, b, a, kPointAtInfinity, c, b, kPointAtInfinity, a, c, kPointAtInfinity};
    dual_.twin.resize(dual_.origin.size());
    for (int k = 0; k < 3; ++k) {
      dual_.link(k, 3 * k + 3);
      dual_.link(3 * k + 4, 3 * ((k + 2) % 3) + 5);
    }
    mark_.resize(4, kNone);
  }

  void insert(int site) {
    int face = faceAround(sites_, dual_, sites_[at(site)].p, hint_);
    if (!isTakenBy(site, face)) {
      isHidden_[at(site)] = true;
      return;
    }
    collect(site, face);
    close(site);
  }

  RegularTriangulation result() && {
    removeFreeFaces();
    RegularTriangulation result = {std::move(dual_), {}};
    for (std::size_t i = 0; i < isHidden_.size(); ++i) {
      if (isHidden_[i]) result.hidden.push_back(static_cast<int>(i));
    }
    return result;
  }

 private:
  /// Whether a site is lifted below the plane of a face. The plane of a face at infinity is vertical. There, the site
  /// is compared with the lifted edge.
  bool isTakenBy(int site, int face) const {
    for (int h = 3 * face; h < 3 * face + 3; ++h) {
      if (isFinite(dual_.origin[at(h)])) continue;
      const WeightedPoint& from = sites_[at(dual_.target(h))];
      const WeightedPoint& to = sites_[at(dual_.origin[at(Dual::previous(h))])];
      const int side = orientation(from.p, to.p, sites_[at(site)].p);
      return side > 0 || (side == 0 && powerTest(from, to, sites_[at(site)]) > 0);
    }
    const auto [a, b, c] = cornersOf(dual_, 3 * face);
    return powerTest(sites_[at(a)], sites_[at(b)], sites_[at(c)], sites_[at(site)]) > 0;
  }

  /// Finds the faces that a site takes, which are connected, and the half-edges around them.
  void collect(int site, int face) {
    taken_ = {face};
    around_.clear();
    mark_[at(face)] = site;
    for (std::size_t k = 0; k < taken_.size(); ++k) {
      for (int h = 3 * taken_[k]; h < 3 * taken_[k] + 3; ++h) {
        const int beyond = dual_.twin[at(h)] / 3;
        if (mark_[at(beyond)] == site) continue;
        if (isTakenBy(site, beyond)) {
          mark_[at(beyond)] = site;
          taken_.push_back(beyond);
        } else {
          around_.push_back(h);
        }
      }
    }
  }

  /// Replaces the taken faces by those between the half-edges around them and the site. Corners that are left inside
  /// are hidden.
  void close(int site) {
    rim_.clear();
    for (const int h : around_) rim_.push_back({dual_.origin[at(h)], dual_.target(h), dual_.twin[at(h)]});
    inside_.clear();
    for (const int face : taken_) {
      for (const int corner : cornersOf(dual_, 3 * face)) inside_.push_back(corner);
    }
    while (taken_.size() < rim_.size()) taken_.push_back(newFace());
    for (std::size_t k = 0; k < rim_.size(); ++k) {
      const auto& [from, to, beyond] = rim_[k];
      const int h = 3 * taken_[k];
      dual_.origin[at(h)] = from;
      dual_.origin[at(h + 1)] = to;
      dual_.origin[at(h + 2)] = site;
      dual_.link(h, beyond);
      faceAt_[placeOf(from)] = taken_[k];
      if (isFinite(from) && isFinite(to)) hint_ = taken_[k];
    }
    for (std::size_t k = 0; k < rim_.size(); ++k) dual_.link(3 * taken_[k] + 1, 3 * faceAt_[placeOf(rim_[k].to)] + 2);
    for (const int corner : inside_) {
      if (isFinite(corner) && faceAt_[placeOf(corner)] == kNone) isHidden_[at(corner)] = true;
    }
    for (const Rim& rim : rim_) faceAt_[placeOf(rim.from)] = kNone;
    for (std::size_t k = rim_.size(); k < taken_.size(); ++k) {
      mark_[at(taken_[k])] = kFree;
      free_.push_back(taken_[k]);
    }
  }

  int newFace() {
    if (!free_.empty()) {
      const int face = free_.back();
      free_.pop_back();
      mark_[at(face)] = kNone;
      return face;
    }
    const int face = dual_.faceCount();
    dual_.origin.resize(dual_.origin.size() + 3);
    dual_.twin.resize(dual_.origin.size());
    mark_.push_back(kNone);
    return face;
  }

  /// Moves the last faces into the places of free ones.
  void removeFreeFaces() {
    std::sort(free_.begin(), free_.end(), std::greater<>());
    for (const int face : free_) {
      const int last = dual_.faceCount() - 1;
      for (int k = 0; k < 3 && face != last; ++k) {
        dual_.origin[at(3 * face + k)] = dual_.origin[at(3 * last + k)];
        dual_.link(3 * face + k, dual_.twin[at(3 * last + k)]);
      }
      dual_.origin.resize(dual_.origin.size() - 3);
      dual_.twin.resize(dual_.origin.size());
    }
    free_.clear();
  }

  static std::size_t placeOf(int corner) { return static_cast<std::size_t>(corner + 1); }

  static constexpr int kFree = -2;

  /// A half-edge around the taken faces, and its twin.
  struct Rim {
    int from, to, beyond;
  };

  std::span<const WeightedPoint> sites_;
  Dual dual_;
  std::vector<int> mark_;    ///< for each face the last site that took it
  std::vector<int> faceAt_;  ///< while faces are replaced: the new face whose rim begins at a corner
  std::vector<bool> isHidden_;
  std::vector<int> free_;
  std::vector<int> taken_;
  std::vector<int> around_;
  std::vector<Rim> rim_;
  std::vector<int> inside_;
  int hint_ = 0;
};

/// Numbers in rounds, each about as large as all before together, and each in increasing order (N. Amenta, S.
/// Choi, G. Rote, "Incremental constructions con BRIO", 2003): of sites in spatial order, row by row, the last would
/// take the faces of all before again and again.
std::vector<int> inRounds(std::size_t count) {
  constexpr int kRounds = 24;
  std::vector<int> rounds(count);
  std::array<std::size_t, kRounds + 1> begins = {};
  for (std::size_t i = 0; i < count; ++i) {
    int round = kRounds - 1;
    for (std::uint64_t bits = mix(i); round > 0 && (bits & 1) != 0; bits >>= 1) --round;
    rounds[i] = round;
    ++begins[static_cast<std::size_t>(round) + 1];
  }
  for (std::size_t k = 1; k < begins.size(); ++k) begins[k] += begins[k - 1];
  std::vector<int> order(count);
  for (std::size_t i = 0; i < count; ++i) order[begins[static_cast<std::size_t>(rounds[i])]++] = static_cast<int>(i);
  return order;
}

/// The edges of a triangulation whose two faces lie in one plane, and the corners with such edges alone.
class FlatParts {
 public:
  FlatParts(std::span<const WeightedPoint> sites, const Dual& dual) : bends_(sites.size(), 0) {
    for (int h = 0; h < dual.halfEdgeCount(); ++h) {
      const int t = dual.twin[at(h)];
      if (t < h) continue;
      if (!dual.isFinite(h / 3) || !dual.isFinite(t / 3)) continue;
      const auto [a, b, c] = cornersOf(dual, h);
      if (powerTest(sites[at(a)], sites[at(b)], sites[at(c)], sites[at(dual.origin[at(Dual::previous(t))])]) == 0) {
        edges_.push_back(h);
      } else {
        ++bends_[at(a)];
        ++bends_[at(b)];
      }
    }
    if (!edges_.empty()) addHull(sites, dual);
  }

  /// Each by one of its half-edges.
  const std::vector<int>& edges() const { return edges_; }

  /// Returns whether the cell of a corner has no interior. A convex surface bends along three edges or more where it
  /// has a corner. Inside a face it bends along none, and along a straight edge along the two parts of this edge.
  bool isFlat(int corner) const { return !edges_.empty() && bends_[at(corner)] < 3; }

 private:
  /// A corner of the hull is none of the surface only if it lies on the lifted line of its two neighbors there.
  void addHull(std::span<const WeightedPoint> sites, const Dual& dual) {
    for (int h = 0; h < dual.halfEdgeCount(); ++h) {
      if (isFinite(dual.origin[at(h)])) continue;
      const int v = dual.target(h);
      const int before = dual.origin[at(Dual::previous(h))];
      const int after = dual.target(dual.aroundClockwise(h));
      const bool isOnLine = orientation(sites[at(before)].p, sites[at(v)].p, sites[at(after)].p) == 0 &&
                            powerTest(sites[at(before)], sites[at(after)], sites[at(v)]) == 0;
      bends_[at(v)] = isOnLine ? 0 : 3;
    }
  }

  std::vector<int> edges_;
  std::vector<int> bends_;  ///< for each site the number of edges at which the surface bends
};

/// Triangulates the sites that are chosen.
RegularTriangulation ofChosen(std::span<const WeightedPoint> sites, const std::vector<int>& chosen) {
  std::vector<WeightedPoint> corners;
  for (const int site : chosen) corners.push_back(sites[at(site)]);
  RegularTriangulation result = regularTriangulation(corners);
  for (int& corner : result.dual.origin) {
    if (isFinite(corner)) corner = chosen[at(corner)];
  }
  for (int& site : result.hidden) site = chosen[at(site)];
  std::vector<bool> isChosen(sites.size(), false);
  for (const int site : chosen) isChosen[at(site)] = true;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    if (!isChosen[i]) result.hidden.push_back(static_cast<int>(i));
  }
  std::sort(result.hidden.begin(), result.hidden.end());
  return result;
}

/// Returns the one triangulation among those of the same surface.
RegularTriangulation settled(RegularTriangulation found, std::span<const WeightedPoint> sites) {
  const FlatParts flat(sites, found.dual);
  if (flat.edges().empty()) return found;
  std::vector<bool> isCorner(sites.size(), true);
  for (const int site : found.hidden) isCorner[at(site)] = false;
  std::vector<int> corners;
  bool hasFlat = false;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const auto site = static_cast<int>(i);
    if (!isCorner[i]) continue;
    if (flat.isFlat(site))
      hasFlat = true;
    else
      corners.push_back(site);
  }
  if (hasFlat) return ofChosen(sites, corners);
  std::vector<Circle> places;
  for (const WeightedPoint& site : sites) places.push_back({site.p.x, site.p.y, 0});
  settleTies(found.dual, flat.edges(), places);
  return found;
}

}  // namespace

RegularTriangulation regularTriangulation(std::span<const WeightedPoint> sites) {
  std::size_t third = 2;
  int turn = 0;
  for (; third < sites.size(); ++third) {
    turn = orientation(sites[0].p, sites[1].p, sites[third].p);
    if (turn != 0) break;
  }
  if (turn == 0) return ofLine(sites);
  const auto corner = static_cast<int>(third);
  Triangulator triangulator(sites, turn > 0 ? std::array{0, 1, corner} : std::array{1, 0, corner});
  for (const int site : inRounds(sites.size())) {
    if (site > 1 && site != corner) triangulator.insert(site);
  }
  return settled(std::move(triangulator).result(), sites);
}

}  // namespace circle_voronoi
