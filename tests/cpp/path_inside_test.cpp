// SPDX-License-Identifier: GPL-3.0-or-later
// Clearest paths inside regions full of ties, against the best path on a grid and against the curves themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "circle_voronoi/compute.h"
#include "circle_voronoi/region_queries.h"
#include "in_circle.h"
#include "path_checks.h"
#include "random.h"
#include "report.h"

namespace circle_voronoi {
namespace path_inside_test {
namespace {

using Ring = Region::Ring;
using Circles = std::vector<Circle>;

constexpr int kSize = 6;
constexpr int kStepsOfUnit = 4;
constexpr int kCount = kSize * kStepsOfUnit + 1;
constexpr double kStep = 1.0 / kStepsOfUnit;
constexpr double kTolerance = 1e-9;
/// The width of a wall that stands for one of a few units of rounding.
constexpr double kThinWall = 1e-7;
constexpr double kThinTolerance = 1e-3;

/// A grid whose points are linked where no side of the region separates them. Its clearest paths are a lower bound.
class Grid {
 public:
  Grid(const Region& region, const Circles& circles) : links_(kCount * kCount) {
    const auto sides = test::sidesOf(region);
    std::vector<bool> isInside;
    for (std::size_t k = 0; k < links_.size(); ++k) isInside.push_back(region.contains(pointAt(k)));
    for (std::size_t k = 0; k < links_.size(); ++k) {
      if (!isInside[k]) continue;
      for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(0, 1), std::pair(1, 1), std::pair(1, -1)}) {
        const int x = static_cast<int>(k) % kCount + dx;
        const int y = static_cast<int>(k) / kCount + dy;
        if (x >= kCount || y >= kCount || y < 0) continue;
        const auto other = static_cast<std::size_t>(x + kCount * y);
        if (!isInside[other]) continue;
        const Point a = pointAt(k);
        const Point b = pointAt(other);
        if (!region.contains({(a.x + b.x) / 2, (a.y + b.y) / 2})) continue;
        if (std::ranges::any_of(sides, [&](const auto& side) { return separates(side, a, b); })) continue;
        const double clearance = test::clearanceAlong(circles, a, b);
        links_[k].emplace_back(other, clearance);
        links_[other].emplace_back(k, clearance);
      }
    }
  }

  static Point pointAt(std::size_t k) {
    return {kStep * static_cast<double>(k % kCount), kStep * static_cast<double>(k / kCount)};
  }

  /// The clearance of the best path; nothing if there is none.
  std::optional<double> best(std::size_t from, std::size_t to) const {
    std::vector<double> keys(links_.size(), -1e300);
    std::priority_queue<std::pair<double, std::size_t>> pending;
    keys[from] = 1e300;
    pending.emplace(1e300, from);
    while (!pending.empty()) {
      const auto [key, k] = pending.top();
      pending.pop();
      if (k == to) return key;
      if (key < keys[k]) continue;
      for (const auto& [next, clearance] : links_[k]) {
        const double there = std::min(key, clearance);
        if (!(there > keys[next])) continue;
        keys[next] = there;
        pending.emplace(there, next);
      }
    }
    return std::nullopt;
  }

 private:
  /// Whether a side touches the interior of a step, but does not run along it: a step from corner to corner of the grid
  /// stays in a closed region otherwise.
  static bool separates(const std::array<Point, 2>& side, Point a, Point b) {
    const int first = orientation(a, b, side[0]);
    const int second = orientation(a, b, side[1]);
    if (first * second > 0 || (first == 0 && second == 0)) return false;
    return orientation(side[0], side[1], a) * orientation(side[0], side[1], b) < 0;
  }

  std::vector<std::vector<std::pair<std::size_t, double>>> links_;
};

/// A region and the same with walls of kThinWall in place of walls of a few units of rounding, if it has such walls.
struct Shape {
  std::optional<Region> region;
  std::optional<Region> wide;
};

std::optional<Region> madeOf(const std::vector<Ring>& rings, bool dissolve) {
  auto region = Region::fromRings(rings, {.dissolve = dissolve});
  if (!region) return std::nullopt;
  return std::move(region).value();
}

void addIfValid(std::vector<Ring>& rings, Ring ring) {
  rings.push_back(std::move(ring));
  if (!madeOf(rings, false)) rings.pop_back();
}

Ring squareAt(double x, double y, double size) { return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}}; }

Shape squares(Random& random) {
  std::vector<std::vector<Ring>> polygons;
  for (int x = 0; x < kSize; ++x) {
    for (int y = 0; y < kSize; ++y) {
      if (random.below(3) != 0) polygons.push_back({squareAt(x, y, 1)});
    }
  }
  if (polygons.empty()) return {};
  auto region = Region::fromPolygons(polygons, {.dissolve = true});
  if (!region) return {};
  return {std::move(region).value(), std::nullopt};
}

Point gridPoint(Random& random) {
  return {static_cast<double>(random.below(kSize + 1)), static_cast<double>(random.below(kSize + 1))};
}

/// Polygons, some with corners on the sides of others.
Shape polygons(Random& random) {
  std::vector<Ring> rings;
  for (std::size_t tries = 40; tries > 0 && rings.size() < 4; --tries) {
    Ring ring;
    for (std::size_t corners = 3 + random.below(4); corners > 0; --corners) ring.push_back(gridPoint(random));
    addIfValid(rings, std::move(ring));
  }
  return {madeOf(rings, false), std::nullopt};
}

/// A square with holes that are triangles and squares of the grid, and may touch.
Shape holes(Random& random) {
  std::vector<Ring> rings = {squareAt(0, 0, kSize)};
  for (std::size_t k = 0; k < 6; ++k) {
    Ring ring = random.below(2) == 0
                    ? squareAt(static_cast<double>(random.below(kSize)), static_cast<double>(random.below(kSize)), 1)
                    : Ring{gridPoint(random), gridPoint(random), gridPoint(random)};
    addIfValid(rings, std::move(ring));
  }
  return {madeOf(rings, false), std::nullopt};
}

/// A U, a comb or a ring.
Shape corridors(Random& random) {
  switch (random.below(3)) {
    case 0:
      return {madeOf({{{0, 0}, {6, 0}, {6, 6}, {4, 6}, {4, 2}, {2, 2}, {2, 6}, {0, 6}}}, false), std::nullopt};
    case 1: {
      Ring ring = {{0, 0}, {6, 0}};
      const double floor = static_cast<double>(1 + random.below(4));
      for (int k = 6; k > 0; k -= 2) {
        ring.push_back({k * 1.0, 6});
        ring.push_back({k - 1.0, 6});
        ring.push_back({k - 1.0, floor});
        ring.push_back({k - 2.0, floor});
      }
      return {madeOf({ring}, false), std::nullopt};
    }
    default: {
      const double width = static_cast<double>(1 + random.below(2));
      return {madeOf({squareAt(0, 0, 6), squareAt(width, width, 6 - 2 * width)}, false), std::nullopt};
    }
  }
}

/// A square with notches and triangles as wide as a few units of rounding at one end.
Shape thinWalls(Random& random) {
  std::vector<Ring> thin = {{{0, 0}, {6, 0}, {6, 6}, {0, 6}}};
  std::vector<Ring> wide = thin;
  for (std::size_t k = 1 + random.below(3); k > 0; --k) {
    const Point foot = random.below(2) == 0 ? Point{static_cast<double>(1 + random.below(5)), 0} : gridPoint(random);
    const Point tip = gridPoint(random);
    if (tip.y == foot.y) continue;
    double x = foot.x;
    for (std::size_t ulps = 1 + random.below(3); ulps > 0; --ulps) x = std::nextafter(x, 1e300);
    const auto add = [&](std::vector<Ring>& rings, double end) {
      if (foot.y > 0) {
        rings.push_back({foot, {end, foot.y}, tip});
        return;
      }
      Ring& ring = rings.front();
      const auto place = std::ranges::find_if(ring, [&](Point p) { return p.y == 0 && p.x > foot.x; });
      const Ring notch = {foot, tip, {end, 0}};
      ring.insert(place, notch.begin(), notch.end());
    };
    std::vector<Ring> thinner = thin;
    std::vector<Ring> wider = wide;
    add(thinner, x);
    add(wider, foot.x + kThinWall);
    if (!madeOf(thinner, false) || !madeOf(wider, false)) continue;
    thin = thinner;
    wide = wider;
  }
  return {madeOf(thin, false), madeOf(wide, false)};
}

Circles circlesOf(Random& random) {
  Circles circles;
  const bool isGrid = random.below(3) != 0;
  for (std::size_t k = 1 + random.below(7); k > 0; --k) {
    const Point p = gridPoint(random);
    const double r = random.below(2) == 0 ? 0 : 0.25 * static_cast<double>(random.below(4));
    if (isGrid) circles.push_back({p.x, p.y, r});
    if (!isGrid) circles.push_back({p.x + random.uniform(-1, 1), p.y + random.uniform(-1, 1), 2 * r * random.unit()});
  }
  return circles;
}

struct Counts {
  int queries = 0;
  int none = 0;
  int refused = 0;
};

/// Expects that the largest disc in a region lies in it, overlaps no circle, and is as large as any around the grid.
void checkDisc(const Diagram& diagram, const Region& region) {
  const auto sides = test::sidesOf(region);
  const auto clearanceAt = [&](Point p) {
    const Circle point = {p.x, p.y, 0};
    double least = test::clearanceAlong(diagram.circles, p, p);
    for (const auto& [from, to] : sides) least = std::min(least, test::clearanceAlong(std::span(&point, 1), from, to));
    return least;
  };
  double best = 0;
  for (std::size_t k = 0; k < kCount * kCount; ++k) {
    if (region.contains(Grid::pointAt(k))) best = std::max(best, clearanceAt(Grid::pointAt(k)));
  }
  const auto disc = largestEmptyDiscInside(diagram, region);
  if (best < kTolerance && !disc) return;
  ASSERT_TRUE(disc && *disc);
  const Vertex& found = (*disc)->disc;
  ASSERT_GE(found.r, best - kTolerance);
  if (found.r <= 0) return;
  ASSERT_TRUE(region.contains({found.x, found.y}));
  ASSERT_NEAR(clearanceAt({found.x, found.y}), found.r, kTolerance);
}

/// Tries paths between points of the grid in one region.
void tryShape(const Shape& shape, Random& random, int queries, Counts& counts) {
  const Circles circles = circlesOf(random);
  const Diagram diagram = compute(circles).value();
  checkDisc(diagram, *shape.region);
  const Grid grid(*shape.region, circles);
  test::PartsOfRegion parts(*shape.region);
  std::vector<std::size_t> inside;
  for (std::size_t k = 0; k < kCount * kCount; ++k) {
    if (shape.region->contains(Grid::pointAt(k))) inside.push_back(k);
  }
  // Half of the points are those with the most ties.
  std::vector<std::size_t> ties;
  for (const std::size_t k : inside) {
    const Point p = Grid::pointAt(k);
    const bool isCorner = std::ranges::any_of(shape.region->points(), [&](Point c) { return c == p; });
    const bool isCenter = std::ranges::any_of(circles, [&](const Circle& c) { return c.x == p.x && c.y == p.y; });
    if (isCorner || isCenter) ties.push_back(k);
  }
  const auto any = [&] {
    const auto& from = !ties.empty() && random.below(2) == 0 ? ties : inside;
    return from[random.below(from.size())];
  };
  for (int k = 0; k < queries && !inside.empty(); ++k) {
    const std::size_t from = any();
    const std::size_t to = any();
    const Point p = Grid::pointAt(from);
    const Point q = Grid::pointAt(to);
    SCOPED_TRACE(::testing::Message() << "from (" << p.x << ", " << p.y << ") to (" << q.x << ", " << q.y << ")");
    const auto path = clearestPath(diagram, p, q, *shape.region);
    ++counts.queries;
    ASSERT_TRUE(path) << path.error().message;
    ASSERT_EQ(path->has_value(), parts.areTogether(p, q));
    if (!*path) {
      ++counts.none;
      continue;
    }
    ASSERT_EQ(test::faultOf(*shape.region, circles, p, q, **path, kTolerance), "");
    const auto least = grid.best(from, to);
    if (least && from != to) {
      ASSERT_GE((*path)->clearance, *least - kTolerance);
    }
    if (!shape.wide || !shape.wide->contains(p) || !shape.wide->contains(q)) continue;
    const auto other = clearestPath(diagram, p, q, *shape.wide);
    ASSERT_TRUE(other && *other);
    ASSERT_NEAR((*path)->clearance, (*other)->clearance, kThinTolerance);
  }
}

int trials() {
  const char* text = std::getenv("CIRCLE_VORONOI_PATH_TRIALS");
  return text == nullptr ? 60 : std::atoi(text);
}

void tryFamily(Shape (*family)(Random&), std::uint64_t seed) {
  Random random(test::seedOr(seed));
  Counts counts;
  for (int trial = 0; trial < trials(); ++trial) {
    SCOPED_TRACE(trial);
    const Shape shape = family(random);
    if (!shape.region) continue;
    tryShape(shape, random, 10, counts);
    if (::testing::Test::HasFatalFailure()) return;
  }
  ::testing::Test::RecordProperty("queries", counts.queries);
  ::testing::Test::RecordProperty("none", counts.none);
  EXPECT_GT(counts.queries, trials());
}

TEST(PathInsideTies, SquaresThatTouchInCorners) { tryFamily(squares, 11); }
TEST(PathInsideTies, PolygonsOfTheGrid) { tryFamily(polygons, 12); }
TEST(PathInsideTies, HolesThatTouch) { tryFamily(holes, 13); }
TEST(PathInsideTies, CorridorsCombsAndRings) { tryFamily(corridors, 14); }
TEST(PathInsideTies, WallsOfAFewUnitsOfRounding) { tryFamily(thinWalls, 15); }

}  // namespace
}  // namespace path_inside_test
}  // namespace circle_voronoi
