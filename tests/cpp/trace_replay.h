// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "circle_voronoi/diagram.h"
#include "circle_voronoi/editor.h"
#include "circle_voronoi/trace.h"

namespace circle_voronoi::test {

using Triple = std::array<CircleIndex, 3>;

/// kNone last if it is among them, else the least first.
inline Triple turned(Triple circles) {
  const auto none = std::ranges::find(circles, kNone);
  if (none != circles.end()) {
    std::rotate(circles.begin(), none + 1, circles.end());
  } else {
    std::rotate(circles.begin(), std::ranges::min_element(circles), circles.end());
  }
  return circles;
}

/// The state of the triangulation according to the events.
class Replay {
 public:
  void see(const TraceEvent& event) {
    const auto& [a, b, c] = event.circles;
    switch (event.kind) {
      case TraceKind::roundBegun:
        faces_.clear();
        waiting_ = 0;
        break;
      case TraceKind::branchDisc:
        // It names its circles clockwise, and where it is nearly infinite, its numbers are rounded.
        faces_[event.vertex] = {{a, c, b}, {NAN, NAN, NAN}, true};
        break;
      case TraceKind::faceMade:
        EXPECT_TRUE(faces_.try_emplace(event.numbers[0], Face{event.circles, event.disc}).second);
        break;
      case TraceKind::faceRemoved: {
        const auto found = faces_.find(event.numbers[0]);
        ASSERT_NE(found, faces_.end());
        EXPECT_EQ(turned(found->second.circles), turned(event.circles));
        if (waiting_ > 0) {
          EXPECT_TRUE(std::ranges::count(event.circles, reason_.circles[0]) > 0) << traceKindName(reason_.kind);
          --waiting_;
        }
        faces_.erase(found);
        break;
      }
      case TraceKind::discNotEmpty:
        expectMeets(event);
        [[fallthrough]];
      case TraceKind::discMissing:
      case TraceKind::tangentNotClear:
      case TraceKind::hullNotConvex:
      case TraceKind::circleShrunk:
        // The point at infinity is no circle.
        EXPECT_NE(event.circles[0], kNone) << traceKindName(event.kind);
        reason_ = event;
        waiting_ = 2;
        ++reasons;
        break;
      case TraceKind::circleInserted:
      case TraceKind::circleReplaced:
        circles_[a] = {event.disc.x, event.disc.y, event.disc.r};
        break;
      case TraceKind::circleRemoved:
        circles_.erase(a);
        break;
      default:
        break;
    }
  }

  void know(const std::vector<Circle>& circles) {
    for (std::size_t i = 0; i < circles.size(); ++i) circles_.emplace(static_cast<std::int32_t>(i), circles[i]);
  }

  /// Circle i of the diagram has the id ids[i].
  void expectDiagram(const Diagram& diagram, const std::vector<CircleId>& ids) const {
    const auto named = [&](const Triple& circles) {
      return turned({ids.at(circles[0]), ids.at(circles[1]), ids.at(circles[2])});
    };
    std::multiset<Triple> expected;
    std::multimap<Triple, Vertex> discs;
    for (std::size_t v = 0; v < diagram.vertices.size(); ++v) {
      expected.insert(named(diagram.vertexCircles[v]));
      discs.emplace(named(diagram.vertexCircles[v]), diagram.vertices[v]);
    }
    std::multiset<Triple> replayed;
    std::multiset<std::array<CircleIndex, 2>> ends;
    for (const auto& [number, face] : faces_) {
      const Triple circles = turned(face.circles);
      if (circles[2] == kNone) {
        ends.insert({circles[1], circles[0]});
        ends.insert({circles[1], circles[0]});
        continue;
      }
      replayed.insert(circles);
      if (std::isnan(face.disc.r)) {
        EXPECT_TRUE(face.isBranch || !diagram.certificate.certified());
        continue;
      }
      const auto [first, last] = discs.equal_range(circles);
      EXPECT_TRUE(std::any_of(first, last, [&](const auto& item) { return isSame(item.second, face.disc); }));
    }
    EXPECT_EQ(replayed, expected);
    if (faces_.empty() ||
        std::ranges::none_of(faces_, [](const auto& item) { return item.second.circles[2] == kNone; }))
      return;
    std::multiset<std::array<CircleIndex, 2>> hull;
    for (std::size_t k = 0; k < diagram.hull.size(); ++k) {
      const std::array<CircleIndex, 2> pair = {ids.at(diagram.hull[k]),
                                               ids.at(diagram.hull[(k + 1) % diagram.hull.size()])};
      hull.insert(pair);
      hull.insert(pair);
    }
    EXPECT_EQ(ends, hull);
  }

  int reasons = 0;

 private:
  struct Face {
    Triple circles;
    Vertex disc;
    bool isBranch = false;
  };

  /// Nearly infinite discs have few digits.
  static bool isSame(const Vertex& a, const Vertex& b) {
    const double size = std::max({std::abs(a.x), std::abs(a.y), std::abs(a.r), std::abs(b.x), std::abs(b.y)});
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.r - b.r)}) <= 0x1p-24 * size;
  }

  void expectMeets(const TraceEvent& event) const {
    const Circle& c = circles_.at(event.circles[2]);
    const Vertex& disc = event.disc;
    const double distance = std::hypot(disc.x - c.x, disc.y - c.y);
    const double size = distance + c.r + std::abs(disc.r) + std::abs(disc.x) + std::abs(disc.y);
    EXPECT_LE(distance - c.r - disc.r, 0x1p-30 * size);
  }

  std::map<std::int32_t, Face> faces_;
  std::map<CircleId, Circle> circles_;
  TraceEvent reason_;
  int waiting_ = 0;
};

/// The ids of the circles of a new diagram: 0, 1, and so on.
inline std::vector<CircleId> firstIds(std::size_t count) {
  std::vector<CircleId> ids(count);
  for (std::size_t i = 0; i < count; ++i) ids[i] = static_cast<std::int32_t>(i);
  return ids;
}

}  // namespace circle_voronoi::test
