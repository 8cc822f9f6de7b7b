// SPDX-License-Identifier: GPL-3.0-or-later
#include "divide_region.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "circle_voronoi/box.h"
#include "infinity.h"
#include "vectors.h"

namespace circle_voronoi {
namespace {

using Rings = std::vector<Region::Ring>;

/// The part of the plane before or behind a line x = place or y = place.
struct HalfPlane {
  bool isAcrossX = true;
  bool isBefore = true;
  double place = 0;

  double depthOf(Point p) const {
    const double depth = place - (isAcrossX ? p.x : p.y);
    return isBefore ? depth : -depth;
  }
};

/// Cuts rings (I. E. Sutherland, G. W. Hodgman, 1974). A ring that is cut apart stays one ring, which runs to and fro
/// along the line. That changes neither areas nor moments.
Rings cut(const Rings& rings, const HalfPlane& half) {
  Rings result;
  for (const Region::Ring& ring : rings) {
    Region::Ring kept;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point p = ring[k];
      const Point q = ring[k + 1 < ring.size() ? k + 1 : 0];
      const double before = half.depthOf(p);
      const double after = half.depthOf(q);
      if (before >= 0) kept.push_back(p);
      if ((before < 0) == (after < 0) || before == 0 || after == 0) continue;
      const double share = before / (before - after);
      Point crossing = {p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)};
      (half.isAcrossX ? crossing.x : crossing.y) = half.place;
      kept.push_back(crossing);
    }
    if (kept.size() > 2) result.push_back(std::move(kept));
  }
  return result;
}

/// Twice the area of rings, and their center of mass.
struct Moments {
  double area = 0;
  Point center;
};

Moments momentsOf(const Rings& rings) {
  Moments sum;
  if (rings.empty()) return sum;
  const Point from = rings[0][0];
  Vector moment;
  for (const Region::Ring& ring : rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point p = ring[k];
      const Point q = ring[k + 1 < ring.size() ? k + 1 : 0];
      const Vector u = {p.x - from.x, p.y - from.y};
      const Vector v = {q.x - from.x, q.y - from.y};
      const double area = cross(u, v);
      sum.area += area;
      moment = {moment.x + area * (u.x + v.x), moment.y + area * (u.y + v.y)};
    }
  }
  sum.center = {from.x + moment.x / (3 * sum.area), from.y + moment.y / (3 * sum.area)};
  return sum;
}

Box boxOf(const Rings& rings) {
  Box box = {kInfinite, kInfinite, -kInfinite, -kInfinite};
  for (const Region::Ring& ring : rings) {
    for (const Point p : ring) {
      box = {std::min(box.minX, p.x), std::min(box.minY, p.y), std::max(box.maxX, p.x), std::max(box.maxY, p.y)};
    }
  }
  return box;
}

/// The middle of the longest piece inside the rings of the horizontal line through a point, or the point if there is
/// none.
Point middleOfChord(const Rings& rings, Point through) {
  std::vector<double> crossings;
  for (const Region::Ring& ring : rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point p = ring[k];
      const Point q = ring[k + 1 < ring.size() ? k + 1 : 0];
      if ((p.y > through.y) == (q.y > through.y)) continue;
      crossings.push_back(p.x + (through.y - p.y) / (q.y - p.y) * (q.x - p.x));
    }
  }
  std::ranges::sort(crossings);
  double longest = 0;
  for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
    const double length = crossings[k + 1] - crossings[k];
    if (length <= longest) continue;
    longest = length;
    through.x = crossings[k] + length / 2;
  }
  return through;
}

class Divider {
 public:
  Divider(const Region& region, std::span<const double> shares)
      : region_(region), shares_(shares), order_(shares.size()), middles_(shares.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::ranges::stable_sort(order_, [&](std::size_t i, std::size_t j) { return shares[j] < shares[i]; });
  }

  std::vector<Point> run() && {
    Rings rings;
    const auto points = region_.points();
    const auto offsets = region_.ringOffsets();
    for (std::size_t k = 0; k + 1 < offsets.size(); ++k) {
      rings.emplace_back(points.begin() + offsets[k], points.begin() + offsets[k + 1]);
    }
    divide({std::move(rings), 0, order_.size()});
    while (!parts_.empty()) {
      Part part = std::move(parts_.back());
      parts_.pop_back();
      divide(std::move(part));
    }
    return std::move(middles_);
  }

 private:
  /// A part for the shares from `begin` to before `end` in the order of size.
  struct Part {
    Rings rings;
    std::size_t begin = 0;
    std::size_t end = 0;
  };

  static constexpr int kHalvings = 40;

  double share(std::size_t k) const { return shares_[order_[k]]; }

  void divide(Part part) {
    const Moments moments = momentsOf(part.rings);
    if (part.end - part.begin == 1 || !(moments.area > 0)) {
      for (std::size_t k = part.begin; k < part.end; ++k) middles_[order_[k]] = middleOf(part.rings, moments);
      return;
    }
    double whole = 0;
    for (std::size_t k = part.begin; k < part.end; ++k) whole += share(k);
    // The first of the two has the larger shares, and half of all or more.
    double first = share(part.begin);
    std::size_t middle = part.begin + 1;
    while (middle + 1 < part.end && first + share(middle) <= whole / 2) first += share(middle++);
    const Box box = boxOf(part.rings);
    const bool isWide = box.maxX - box.minX >= box.maxY - box.minY;
    double low = isWide ? box.minX : box.minY;
    double high = isWide ? box.maxX : box.maxY;
    for (int k = 0; k < kHalvings; ++k) {
      const double place = low + (high - low) / 2;
      const double area = momentsOf(cut(part.rings, {isWide, true, place})).area;
      (area * whole < moments.area * first ? low : high) = place;
    }
    parts_.push_back({cut(part.rings, {isWide, false, low}), middle, part.end});
    parts_.push_back({cut(part.rings, {isWide, true, high}), part.begin, middle});
  }

  Point middleOf(const Rings& rings, const Moments& moments) const {
    if (!(moments.area > 0)) return rings.empty() ? region_.points()[0] : rings[0][0];
    return region_.contains(moments.center) ? moments.center : middleOfChord(rings, moments.center);
  }

  const Region& region_;
  std::span<const double> shares_;
  std::vector<std::size_t> order_;
  std::vector<Point> middles_;
  std::vector<Part> parts_;
};

}  // namespace

std::vector<Point> middlesOfParts(const Region& region, std::span<const double> shares) {
  return Divider(region, shares).run();
}

}  // namespace circle_voronoi
