// SPDX-License-Identifier: GPL-3.0-or-later
#include "meetings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "at.h"
#include "in_circle.h"
#include "relative_circle.h"
#include "ring_sweep.h"

namespace circle_voronoi {
namespace {

/// Two lines that are not vertical, compared at the x of a point.
struct Order {
  int heights;  ///< the sign of the first line's height minus that of the second, there
  int slopes;   ///< the sign of the first line's slope minus that of the second
};

/// Compares the lines through a, b and through c, d. If lines go from right to left or are vertical, both signs may be
/// wrong; their product is right.
Order exactOrder(Point a, Point b, Point c, Point d, Point p) {
  const auto circleAt = [](Point q) { return Circle{q.x, q.y, 0}; };
  const std::array ends = {circleAt(a), circleAt(b), circleAt(c), circleAt(d)};
  return exact::seenFrom(circleAt(p), std::array{&ends[0], &ends[1], &ends[2], &ends[3]}, [](const auto& seen, int) {
    const auto first = seen[1].v - seen[0].v;
    const auto second = seen[3].v - seen[2].v;
    const auto aboveFirst = exact::planeCross(seen[0].v, seen[1].v);
    const auto aboveSecond = exact::planeCross(seen[2].v, seen[3].v);
    return Order{(aboveSecond * first.x - aboveFirst * second.x).sign(), exact::planeCross(second, first).sign()};
  });
}

/// The sweep line through an end is tilted a little, so that it meets the ends of one x from below, one by one.
class Search {
 public:
  Search(std::span<const Point> points, std::span<const Segment> segments, std::size_t most)
      : points_(points), segments_(segments), most_(most), place_(points.size(), kNone) {
    for (const auto& [a, b] : segments) {
      for (const std::int32_t end : {a, b}) {
        if (std::exchange(place_[at(end)], 0) == kNone) ends_.push_back(end);
      }
    }
    std::ranges::sort(ends_, [&](std::int32_t i, std::int32_t j) { return isBefore(points[at(i)], points[at(j)]); });
    for (std::size_t k = 0; k < ends_.size(); ++k) place_[at(ends_[k])] = static_cast<std::int32_t>(k);
    places_.resize(ends_.size());
  }

  std::optional<Meetings> run() {
    std::vector<std::int32_t> all(segments_.size());
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = static_cast<std::int32_t>(k);
    searchSlab(0, static_cast<std::int32_t>(ends_.size()) - 1, std::move(all));
    if (isFull()) return {};
    return std::move(found_);
  }

 private:
  /// The height of a segment above an end, at the end's x.
  struct Height {
    double value = 0;
    double error = 0;
  };
  /// A segment that goes through a slab.
  struct Through {
    std::int32_t segment;
    Height left;
    Height right;
  };
  /// A place among the levels of a slab: those before `first` are below it, and those from `last` on are above it.
  struct Place {
    std::size_t first;
    std::size_t last;
  };

  bool isFull() const { return found_.crossings.size() + found_.touches.size() > most_; }

  Point pointOf(std::int32_t end) const { return points_[at(ends_[at(end)])]; }
  std::int32_t startOf(std::int32_t segment) const { return place_[at(segments_[at(segment)].a)]; }
  std::int32_t stopOf(std::int32_t segment) const { return place_[at(segments_[at(segment)].b)]; }
  bool hasEnd(std::int32_t segment, std::int32_t end) const {
    return startOf(segment) == end || stopOf(segment) == end;
  }

  /// Returns 1 if an end lies above a segment, -1 if it lies below, 0 if it lies on the segment.
  int sideOf(std::int32_t segment, std::int32_t end) const {
    if (hasEnd(segment, end)) return 0;
    const auto& [a, b] = segments_[at(segment)];
    return orientation(points_[at(a)], points_[at(b)], pointOf(end));
  }

  Height heightAt(std::int32_t segment, std::int32_t end) const {
    const auto& [a, b] = segments_[at(segment)];
    const double width = points_[at(b)].x - points_[at(a)].x;
    // The line meets a vertical segment in the end.
    if (width == 0 || hasEnd(segment, end)) return {};
    const Estimate above = orientationOf(points_[at(a)], points_[at(b)], pointOf(end));
    const double height = -above.value / width;
    return {height, (above.error / width + 4 * kUnitRoundoff * std::abs(height)) * (1 + 0x1p-40)};
  }

  /// Returns the sign of the height of segment s minus that of segment t, where the line meets an end.
  int compare(std::int32_t s, const Height& ofS, std::int32_t t, const Height& ofT, std::int32_t end) const {
    const double difference = ofS.value - ofT.value;
    if (std::abs(difference) > (ofS.error + ofT.error) * (1 + 0x1p-40)) return difference > 0 ? 1 : -1;
    const int aboveS = sideOf(s, end);
    const int aboveT = sideOf(t, end);
    if (aboveS != aboveT) return aboveS < aboveT ? 1 : -1;
    if (aboveS == 0) return 0;
    const Point a = points_[at(segments_[at(s)].a)];
    const Point b = points_[at(segments_[at(s)].b)];
    const Point c = points_[at(segments_[at(t)].a)];
    const Point d = points_[at(segments_[at(t)].b)];
    if (a.y == b.y && c.y == d.y) return a.y > c.y ? 1 : a.y < c.y ? -1 : 0;
    const auto [heights, slopes] = exactOrder(a, b, c, d, pointOf(end));
    // Below the end, the tilted line meets them right of their crossing, and above the end left of it.
    return heights != 0 ? heights : aboveS * slopes;
  }
  int compareLeft(const Through& s, const Through& t, std::int32_t lo) const {
    return compare(s.segment, s.left, t.segment, t.left, lo);
  }
  int compareRight(const Through& s, const Through& t, std::int32_t hi) const {
    return compare(s.segment, s.right, t.segment, t.right, hi);
  }

  /// Searches among segments that all meet the inside of the slab between two ends.
  void searchSlab(std::int32_t lo, std::int32_t hi, std::vector<std::int32_t> segments) {
    // All ends inside are theirs.
    if (segments.size() < 2 || isFull()) return;
    std::vector<Through> through;
    std::vector<std::int32_t> others;
    for (const std::int32_t s : segments) {
      if (startOf(s) <= lo && stopOf(s) >= hi) {
        through.push_back({s, heightAt(s, lo), heightAt(s, hi)});
      } else {
        others.push_back(s);
      }
    }
    segments = {};
    std::ranges::sort(through, [&](const Through& s, const Through& t) {
      const int left = compareLeft(s, t, lo);
      return (left != 0 ? left : compareRight(s, t, hi)) < 0;
    });
    if (hi - lo == 1) return findInversions(through, hi);
    std::vector<Through> levels;
    std::vector<Through> crossed;
    for (const Through& t : through) {
      (levels.empty() || compareRight(levels.back(), t, hi) <= 0 ? levels : crossed).push_back(t);
    }
    if (!levels.empty()) {
      placeEnds(levels, lo, hi);
      for (const Through& t : crossed) {
        addCrossings(t.segment, placeAtBoundary(levels, t.segment, t.left, &Through::left, lo),
                     placeAtBoundary(levels, t.segment, t.right, &Through::right, hi), levels);
      }
      for (const std::int32_t s : others) {
        const std::int32_t start = startOf(s);
        const std::int32_t stop = stopOf(s);
        addCrossings(
            s, start > lo ? places_[at(start)] : placeAtBoundary(levels, s, heightAt(s, lo), &Through::left, lo),
            stop < hi ? places_[at(stop)] : placeAtBoundary(levels, s, heightAt(s, hi), &Through::right, hi), levels);
      }
    }
    for (const Through& t : crossed) others.push_back(t.segment);
    const std::int32_t middle = lo + (hi - lo) / 2;
    std::vector<std::int32_t> left;
    std::vector<std::int32_t> right;
    for (const std::int32_t s : others) {
      const bool isLeft = startOf(s) < middle;
      const bool isRight = stopOf(s) > middle;
      if (isLeft) left.push_back(s);
      if (isRight) right.push_back(s);
      if (isLeft && isRight && sideOf(s, middle) == 0) found_.touches.push_back({s, ends_[at(middle)]});
    }
    others = {};
    through = {};
    levels = {};
    crossed = {};
    searchSlab(lo, middle, std::move(left));
    searchSlab(middle, hi, std::move(right));
  }

  /// Finds the crossings in a slab without ends inside. Segments are sorted by their order on the left.
  void findInversions(std::vector<Through>& sorted, std::int32_t hi) {
    for (std::size_t k = 1; k < sorted.size() && !isFull(); ++k) {
      for (std::size_t i = k; i > 0 && compareRight(sorted[i - 1], sorted[i], hi) > 0; --i) {
        found_.crossings.push_back({sorted[i - 1].segment, sorted[i].segment});
        std::swap(sorted[i - 1], sorted[i]);
      }
    }
  }

  /// Finds the places of the ends inside a slab among its levels, and the levels on which they lie.
  void placeEnds(const std::vector<Through>& levels, std::int32_t lo, std::int32_t hi) {
    for (std::int32_t end = lo + 1; end < hi; ++end) {
      const auto first =
          std::ranges::partition_point(levels, [&](const Through& level) { return sideOf(level.segment, end) > 0; });
      auto last = first;
      for (; last != levels.end() && !isFull() && sideOf(last->segment, end) == 0; ++last) {
        found_.touches.push_back({last->segment, ends_[at(end)]});
      }
      places_[at(end)] = {static_cast<std::size_t>(first - levels.begin()),
                          static_cast<std::size_t>(last - levels.begin())};
    }
  }

  Place placeAtBoundary(const std::vector<Through>& levels, std::int32_t s, const Height& ofS, Height Through::*height,
                        std::int32_t boundary) const {
    const auto signOf = [&](const Through& level) { return compare(level.segment, level.*height, s, ofS, boundary); };
    const auto first = std::ranges::partition_point(levels, [&](const Through& level) { return signOf(level) < 0; });
    const auto last =
        std::partition_point(first, levels.end(), [&](const Through& level) { return signOf(level) == 0; });
    return {static_cast<std::size_t>(first - levels.begin()), static_cast<std::size_t>(last - levels.begin())};
  }

  /// Adds the levels that a segment crosses on its way from one place to another.
  void addCrossings(std::int32_t s, const Place& from, const Place& to, const std::vector<Through>& levels) {
    const auto add = [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last && !isFull(); ++k) found_.crossings.push_back({levels[k].segment, s});
    };
    add(from.last, to.first);
    add(to.last, from.first);
  }

  std::span<const Point> points_;
  std::span<const Segment> segments_;
  std::size_t most_;
  std::vector<std::int32_t> ends_;   ///< the points that are ends, in the order of the sweep
  std::vector<std::int32_t> place_;  ///< of each point in ends_
  std::vector<Place> places_;        ///< of the ends in the slab that is searched
  Meetings found_;
};

}  // namespace

std::optional<Meetings> meetingsOf(std::span<const Point> points, std::span<const Segment> segments, std::size_t most) {
  return Search(points, segments, most).run();
}

int sideOfCrossing(Point a, Point b, Point c, Point d, double x) {
  const auto [heights, slopes] = exactOrder(a, b, c, d, {x, a.y});
  return heights * slopes;
}

}  // namespace circle_voronoi
