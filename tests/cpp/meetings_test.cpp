// SPDX-License-Identifier: GPL-3.0-or-later
// Where segments meet, compared with all pairs of segments.
#include "meetings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "in_circle.h"
#include "report.h"
#include "ring_sweep.h"

namespace circle_voronoi {
namespace {

using Pair = std::pair<std::int32_t, std::int32_t>;

/// Points and segments between them, each once.
struct Figure {
  std::vector<Point> points;
  std::vector<Segment> segments;

  std::int32_t indexOf(Point p) {
    p = {p.x + 0.0, p.y + 0.0};
    const auto found = std::ranges::find(points, p);
    if (found == points.end()) points.push_back(p);
    return static_cast<std::int32_t>(std::ranges::find(points, p) - points.begin());
  }
  void add(Point p, Point q) {
    if (isBefore(q, p)) std::swap(p, q);
    const std::int32_t a = indexOf(p);
    const Segment segment = {a, indexOf(q)};
    if (p != q && std::ranges::find(segments, segment) == segments.end()) segments.push_back(segment);
  }
  Point at(std::int32_t k) const { return points[static_cast<std::size_t>(k)]; }
  int sideOf(const Segment& s, std::int32_t k) const { return orientation(at(s.a), at(s.b), at(k)); }
  bool hasInside(const Segment& s, std::int32_t k) const {
    return sideOf(s, k) == 0 && isBefore(at(s.a), at(k)) && isBefore(at(k), at(s.b));
  }
};

Figure figureOf(int kind, std::mt19937& random) {
  const auto below = [&](unsigned count) { return static_cast<double>(random() % count); };
  const auto digits = [&](double value) {
    for (auto k = random() % 5; k > 0; --k) value = std::nextafter(value, random() % 2 == 0 ? -1e9 : 1e9);
    return value;
  };
  Figure figure;
  const std::size_t count = 2 + random() % 40;
  const double slope = below(9) / 4 - 1;
  for (std::size_t k = 0; k < count; ++k) {
    switch (kind) {
      case 0:  // integers: common ends, overlaps, crossings at ends
        figure.add({below(6), below(6)}, {below(6), below(6)});
        break;
      case 1:
        figure.add({below(1000) / 7, below(1000) / 9}, {below(1000) / 7, below(1000) / 9});
        break;
      case 2:  // copies of a few segments, off by some digits
        figure.add({digits(1 + below(2) / 3), digits(1 + below(3) / 7)},
                   {digits(5 + below(2) / 3), digits(1 + below(3) / 7)});
        break;
      case 3:  // spokes of one hub, and some across
        figure.add({1, 1}, {1 + below(9) - 4, 1 + below(9) - 4});
        if (k % 4 == 0) figure.add({below(9) - 3, 5}, {below(9) - 3, -3});
        break;
      case 4:  // along the axes
        if (const double at = below(8); random() % 2 == 0) {
          figure.add({at, below(8)}, {at, below(8)});
        } else {
          figure.add({below(8), at}, {below(8), at});
        }
        break;
      default: {  // nearly parallel, long and near one another
        const double y = below(1000) / 1000;
        figure.add({0, y}, {1000 + below(3), slope * 1000 + y + (random() % 8 == 0 ? below(3) - 1 : 0)});
      }
    }
  }
  return figure;
}

TEST(Meetings, AreThoseOfAllPairs) {
  std::mt19937 random(static_cast<std::uint32_t>(test::seedOr(1)));
  std::size_t crossings = 0;
  std::size_t touches = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const Figure figure = figureOf(trial % 6, random);
    const auto& segments = figure.segments;
    const auto found = meetingsOf(figure.points, segments, 1'000'000);
    ASSERT_TRUE(found);
    std::set<Pair> touched;
    for (const auto& [segment, point] : found->touches) EXPECT_TRUE(touched.emplace(segment, point).second) << trial;
    std::set<Pair> crossed;
    for (const auto& [i, j] : found->crossings) EXPECT_TRUE(crossed.insert(std::minmax(i, j)).second) << trial;

    std::set<std::int32_t> ends;
    for (const auto& [a, b] : segments) ends.insert({a, b});
    std::set<Pair> expected;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      for (const std::int32_t end : ends) {
        if (figure.hasInside(segments[i], end)) expected.emplace(static_cast<std::int32_t>(i), end);
      }
    }
    EXPECT_EQ(touched, expected) << trial;
    touches += expected.size();
    for (std::size_t i = 0; i < segments.size(); ++i) {
      for (std::size_t j = i + 1; j < segments.size(); ++j) {
        const Segment& s = segments[i];
        const Segment& t = segments[j];
        const bool isCrossing =
            figure.sideOf(s, t.a) * figure.sideOf(s, t.b) < 0 && figure.sideOf(t, s.a) * figure.sideOf(t, s.b) < 0;
        const bool isAtEnd = std::ranges::any_of(
            ends, [&](std::int32_t end) { return figure.hasInside(s, end) && figure.hasInside(t, end); });
        const bool isFound = crossed.contains({static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)});
        if (isAtEnd) {
          EXPECT_LE(isFound, isCrossing) << trial;
        } else {
          EXPECT_EQ(isFound, isCrossing) << trial << ": " << i << ' ' << j;
          crossings += isCrossing ? 1 : 0;
        }
      }
    }
    // Nothing is found that exceeds the bound.
    const std::size_t count = found->crossings.size() + found->touches.size();
    EXPECT_TRUE(meetingsOf(figure.points, segments, count));
    EXPECT_TRUE(count == 0 || !meetingsOf(figure.points, segments, count - 1));
  }
  EXPECT_GT(crossings, 50'000);
  EXPECT_GT(touches, 15'000);
}

/// The lines through the corners of small squares cross at multiples of 1/2, of 1/3 and so on.
TEST(Meetings, OfTwoLinesLieOnTheExactSide) {
  std::mt19937 random(static_cast<std::uint32_t>(test::seedOr(2)));
  int ties = 0;
  for (int trial = 0; trial < 20'000; ++trial) {
    const auto below = [&](int count) { return static_cast<std::int64_t>(random() % static_cast<unsigned>(count)); };
    const std::int64_t ax = below(9), ay = below(9), bx = below(9), by = below(9);
    const std::int64_t cx = below(9), cy = below(9), dx = below(9), dy = below(9);
    const std::int64_t slope = (bx - ax) * (dy - cy) - (by - ay) * (dx - cx);
    if (slope == 0) continue;
    // The crossing is at ax + (bx - ax) share / slope.
    const std::int64_t share = (cx - ax) * (dy - cy) - (cy - ay) * (dx - cx);
    const std::int64_t twiceX = below(20) - 2;
    const std::int64_t difference = (twiceX * slope - 2 * (ax * slope + (bx - ax) * share)) * (slope > 0 ? 1 : -1);
    const int expected = difference > 0 ? 1 : difference < 0 ? -1 : 0;
    if (expected == 0) ++ties;
    // Far away and in small units, the sign is the same.
    for (const auto& [unit, far] : {std::pair{1.0, 0.0}, {0x1p-40, 1024.0}, {0x1p40, -0x1p90}}) {
      const auto in = [step = unit, start = far](std::int64_t value) {
        return start + step * static_cast<double>(value);
      };
      EXPECT_EQ(sideOfCrossing({in(ax), in(ay)}, {in(bx), in(by)}, {in(cx), in(cy)}, {in(dx), in(dy)},
                               far + unit * static_cast<double>(twiceX) / 2),
                expected)
          << trial;
    }
  }
  EXPECT_GT(ties, 300);
}

}  // namespace
}  // namespace circle_voronoi
