// SPDX-License-Identifier: GPL-3.0-or-later
#include "valid_polygons.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "at.h"
#include "circle_voronoi/index.h"
#include "circle_voronoi/region.h"
#include "guarded.h"
#include "in_circle.h"
#include "ring_sweep.h"
#include "rounded.h"
#include "vectors.h"

namespace circle_voronoi {
namespace {

using Polygons = std::vector<std::vector<PointRing>>;

/// Rings thinner than this share of coordinates have no area but for rounding.
constexpr double kThinRing = 0x1p-48;
/// Points nearer to a step than this share of coordinates lie on it, except for rounding.
constexpr double kOnStep = 0x1p-47;

std::pair<double, double> keyOf(Point p) { return {p.x, p.y}; }
Vector stepFrom(Point p, Point q) { return {q.x - p.x, q.y - p.y}; }

/// Whether the way from a to b goes back from there to c.
bool goesBack(Point a, Point b, Point c) {
  return a == c || (orientation(a, b, c) == 0 && dot(stepFrom(b, a), stepFrom(b, c)) > 0);
}

/// Takes out repeated points and steps there and back.
void cleanRing(PointRing& ring) {
  PointRing kept;
  kept.reserve(ring.size());
  const auto dropTip = [&](Point next) {
    while (kept.size() >= 2 && goesBack(kept[kept.size() - 2], kept.back(), next)) kept.pop_back();
  };
  for (const Point p : ring) {
    dropTip(p);
    if (kept.empty() || kept.back() != p) kept.push_back(p);
  }
  // The point where the ring closes.
  std::size_t first = 0;
  for (bool isClean = false; !isClean && kept.size() >= first + 3;) {
    isClean = false;
    if (kept.back() == kept[first] || goesBack(kept[kept.size() - 2], kept.back(), kept[first])) {
      kept.pop_back();
    } else if (goesBack(kept.back(), kept[first], kept[first + 1])) {
      ++first;
    } else {
      isClean = true;
    }
  }
  ring.assign(kept.begin() + static_cast<std::ptrdiff_t>(first), kept.end());
  if (ring.size() < 3) ring.clear();
}

double areaOf(const PointRing& ring) {
  double sum = 0;
  for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
    sum += cross(stepFrom(ring[0], ring[k]), stepFrom(ring[0], ring[k + 1]));
  }
  return sum / 2;
}

bool isThin(const PointRing& ring) {
  double size = 0;
  double way = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vector step = stepFrom(ring[k], ring[k + 1 == ring.size() ? 0 : k + 1]);
    way += std::abs(step.x) + std::abs(step.y);
    size = std::max({size, std::abs(ring[k].x), std::abs(ring[k].y)});
  }
  return !(std::abs(areaOf(ring)) > kThinRing * size * way);
}

/// The steps of rings between numbered points.
class Steps {
 public:
  explicit Steps(const std::vector<PointLoop>& loops) {
    for (const PointLoop& loop : loops) points_.insert(points_.end(), loop.points.begin(), loop.points.end());
    std::ranges::sort(points_, {}, keyOf);
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
    for (const PointLoop& loop : loops) addRing(loop.points);
    cancel();
    first_.assign(points_.size() + 1, 0);
    for (const auto& [from, to] : steps_) ++first_[static_cast<std::size_t>(from) + 1];
    for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
  }

  /// Closed walks around the connected parts of the area left of the steps, divided into rings where a walk touches
  /// itself.
  std::vector<std::vector<PointRing>> walks() {
    std::vector<std::vector<PointRing>> result;
    isUsed_.assign(steps_.size(), 0);
    place_.assign(points_.size(), kNone);
    for (std::size_t s = 0; s < steps_.size(); ++s) {
      if (isUsed_[s] == 0) result.push_back(walkFrom(s));
    }
    return result;
  }

 private:
  struct Step {
    std::int32_t from, to;
    friend auto operator<=>(const Step&, const Step&) = default;
  };

  std::int32_t numberOf(Point p) const {
    return static_cast<std::int32_t>(std::ranges::lower_bound(points_, keyOf(p), {}, keyOf) - points_.begin());
  }
  Point pointOf(std::int32_t number) const { return points_[static_cast<std::size_t>(number)]; }

  void addRing(const PointRing& ring) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      steps_.push_back({numberOf(ring[k]), numberOf(ring[k + 1 == ring.size() ? 0 : k + 1])});
    }
  }

  /// Sorts the steps and takes out pairs there and back.
  void cancel() {
    std::ranges::sort(steps_);
    std::vector<Step> kept;
    for (std::size_t s = 0; s < steps_.size();) {
      const Step step = steps_[s];
      const auto [first, last] = std::equal_range(steps_.begin(), steps_.end(), step);
      const auto [back, backEnd] = std::equal_range(steps_.begin(), steps_.end(), Step{step.to, step.from});
      const auto count = last - first;
      for (auto k = backEnd - back; k < count; ++k) kept.push_back(step);
      s += static_cast<std::size_t>(count);
    }
    steps_.swap(kept);
  }

  /// Whether, turning counter-clockwise around p from a to b, one meets q in between.
  static bool isBetween(Point p, Point a, Point b, Point q) {
    if (orientation(p, a, b) > 0) return orientation(p, a, q) > 0 && orientation(p, q, b) > 0;
    return !(orientation(p, b, q) >= 0 && orientation(p, q, a) >= 0);
  }

  /// The step that goes on after another one in a walk: the next one clockwise from the way back. If that is the start
  /// of the walk, returns the number of steps.
  std::size_t after(const Step& step, std::size_t start) const {
    const Point back = pointOf(step.from);
    const Point p = pointOf(step.to);
    std::size_t best = steps_.size();
    for (std::size_t s = first_[static_cast<std::size_t>(step.to)]; s < first_[static_cast<std::size_t>(step.to) + 1];
         ++s) {
      if (isUsed_[s] != 0 && s != start) continue;
      if (best == steps_.size() || isBetween(p, pointOf(steps_[best].to), back, pointOf(steps_[s].to))) best = s;
    }
    return best == start ? steps_.size() : best;
  }

  std::vector<PointRing> walkFrom(std::size_t start) {
    std::vector<PointRing> rings;
    std::vector<std::int32_t> open;
    for (std::size_t s = start; s != steps_.size(); s = after(steps_[s], start)) {
      isUsed_[s] = 1;
      const std::int32_t from = steps_[s].from;
      if (const std::int32_t place = place_[static_cast<std::size_t>(from)]; place != kNone) {
        takeRing(open, static_cast<std::size_t>(place), rings);
      }
      place_[static_cast<std::size_t>(from)] = static_cast<std::int32_t>(open.size());
      open.push_back(from);
    }
    takeRing(open, 0, rings);
    return rings;
  }

  void takeRing(std::vector<std::int32_t>& open, std::size_t begin, std::vector<PointRing>& rings) {
    PointRing ring;
    for (std::size_t k = begin; k < open.size(); ++k) {
      ring.push_back(pointOf(open[k]));
      place_[static_cast<std::size_t>(open[k])] = kNone;
    }
    open.resize(begin);
    cleanRing(ring);
    if (!ring.empty() && !isThin(ring)) rings.push_back(std::move(ring));
  }

  std::vector<Point> points_;
  std::vector<Step> steps_;         ///< sorted
  std::vector<std::size_t> first_;  ///< of the steps from each point
  std::vector<std::uint8_t> isUsed_;
  std::vector<std::int32_t> place_;  ///< of each point in the walk, or kNone
};

/// Puts holes that touch no outer ring into the smallest outer ring around them; all into the first polygon where
/// rounding leaves none.
void addHoles(std::vector<PointRing> holes, Polygons& polygons) {
  if (holes.empty() || polygons.empty()) return;
  std::optional<RingOrder> order;
  if (polygons.size() > 1) {
    Rings rings = {{}, {0}};
    const auto add = [&](const PointRing& ring) {
      rings.points.insert(rings.points.end(), ring.begin(), ring.end());
      rings.offsets.push_back(static_cast<std::int32_t>(rings.points.size()));
    };
    for (const auto& polygon : polygons) add(polygon.front());
    for (const PointRing& hole : holes) add(hole);
    order = orderIfApart(rings);
  }
  const auto outerCount = static_cast<std::int32_t>(polygons.size());
  auto ring = outerCount;
  for (PointRing& hole : holes) {
    std::int32_t around = order ? order->parent[at(ring++)] : 0;
    while (around >= outerCount) around = order->parent[at(around)];
    polygons[at(std::max(around, 0))].push_back(std::move(hole));
  }
}

bool haveRepeatedPoints(const std::vector<PointLoop>& loops) {
  std::vector<Point> points;
  for (const PointLoop& loop : loops) points.insert(points.end(), loop.points.begin(), loop.points.end());
  std::ranges::sort(points, {}, keyOf);
  return std::ranges::adjacent_find(points) != points.end();
}

/// Divides steps where other points of the cell lie on them, except for rounding: where a border touches a side.
void divideSteps(std::vector<PointLoop>& loops) {
  std::vector<Point> all;
  for (const PointLoop& loop : loops) all.insert(all.end(), loop.points.begin(), loop.points.end());
  std::ranges::sort(all, {}, keyOf);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  for (PointLoop& loop : loops) {
    PointRing ring;
    for (std::size_t k = 0; k < loop.points.size(); ++k) {
      const Point a = loop.points[k];
      const Point b = loop.points[k + 1 == loop.points.size() ? 0 : k + 1];
      ring.push_back(a);
      const Vector along = stepFrom(a, b);
      const double square = dot(along, along);
      const double reach = kOnStep * (std::abs(a.x) + std::abs(a.y) + std::abs(b.x) + std::abs(b.y));
      std::vector<std::pair<double, Point>> between;
      const auto first = std::ranges::lower_bound(all, std::min(a.x, b.x) - reach, {}, &Point::x);
      for (auto p = first; p != all.end() && p->x <= std::max(a.x, b.x) + reach; ++p) {
        const Vector toPoint = stepFrom(a, *p);
        const double share = dot(toPoint, along) / square;
        if (*p == a || *p == b || !(share > 0 && share < 1)) continue;
        if (std::abs(cross(along, toPoint)) <= reach * std::sqrt(square)) between.emplace_back(share, *p);
      }
      std::ranges::sort(between, {}, &std::pair<double, Point>::first);
      for (const auto& [share, p] : between) ring.push_back(p);
    }
    loop.points = std::move(ring);
  }
}

Polygons polygonsOf(const std::vector<PointLoop>& loops) {
  Polygons polygons;
  if (!haveRepeatedPoints(loops)) {
    bool isKept = false;  // whether the last outer ring is
    for (const PointLoop& loop : loops) {
      const bool isRing = !loop.points.empty() && !isThin(loop.points);
      if (!loop.isHole) {
        isKept = isRing;
        if (isKept) polygons.push_back({loop.points});
      } else if (isRing && isKept) {
        polygons.back().push_back(loop.points);
      }
    }
    return polygons;
  }
  std::vector<PointRing> holes;
  for (auto& rings : Steps(loops).walks()) {
    const auto hole =
        std::partition(rings.begin(), rings.end(), [](const PointRing& ring) { return areaOf(ring) > 0; });
    if (hole - rings.begin() == 1) {
      polygons.push_back(std::move(rings));
      continue;
    }
    for (auto ring = rings.begin(); ring != hole; ++ring) polygons.push_back({std::move(*ring)});
    std::move(hole, rings.end(), std::back_inserter(holes));
  }
  addHoles(std::move(holes), polygons);
  return polygons;
}

}  // namespace

Polygons validPolygons(std::vector<PointLoop> loops) {
  for (PointLoop& loop : loops) {
    for (Point& p : loop.points) p = rounded(p);
    cleanRing(loop.points);
  }
  Polygons polygons = polygonsOf(loops);
  if (polygons.empty() || Region::fromPolygons(polygons)) return polygons;
  divideSteps(loops);
  for (PointLoop& loop : loops) cleanRing(loop.points);
  return polygonsOf(loops);
}

}  // namespace circle_voronoi
