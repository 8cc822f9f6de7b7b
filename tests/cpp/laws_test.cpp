// SPDX-License-Identifier: GPL-3.0-or-later
// The laws that the headers of exact signs state, on random circles and on exact and nearly exact ties.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "brute_force.h"
#include "circle_voronoi/cells.h"
#include "circle_voronoi/compute.h"
#include "distance_signs.h"
#include "exact.h"
#include "in_circle.h"
#include "predicates.h"
#include "random.h"
#include "report.h"
#include "shifted_signs.h"
#include "tie_inputs.h"
#include "validate.h"
#include "weighted_point.h"

namespace circle_voronoi {
namespace laws_test {
namespace {

/// Passes on random circles and ties, rounded, until a law is broken.
void forEachInput(std::size_t count, std::uint64_t trials,
                  const std::function<void(const std::vector<Circle>&, Random&)>& use) {
  const std::uint64_t seed = test::seedOr(1);
  const auto check = [&](std::vector<Circle> circles, std::string_view kind, std::uint64_t trial, Random& random) {
    for (Circle& c : circles) c = rounded(c);
    use(circles, random);
    if (testing::Test::HasFailure()) {
      FAIL() << kind << ", seed " << seed << ", trial " << trial << test::describe(circles);
    }
  };
  for (std::uint64_t trial = 0; trial < trials && !testing::Test::HasFailure(); ++trial) {
    Random random(seed * 1'000'003 + trial);
    std::vector<Circle> circles;
    for (std::size_t i = 0; i < count; ++i) {
      circles.push_back({random.uniform(-10, 10), random.uniform(-10, 10), 4 * random.unit()});
    }
    check(circles, "random", trial, random);
    for (const test::TieKind& kind : test::tieKinds()) {
      auto ties = kind.make(count, random);
      test::disturb(ties, test::Disturbance{static_cast<int>(trial % test::kDisturbances)}, random);
      check(ties, kind.name, trial, random);
    }
  }
}

std::vector<Circle> visible(const std::vector<Circle>& circles) {
  const auto hidden = test::hiddenByDefinition(circles);
  std::vector<Circle> result;
  for (std::size_t i = 0; i < circles.size(); ++i) {
    const auto isThis = [&](const HiddenCircle& h) { return h.circle == static_cast<std::int32_t>(i); };
    if (std::ranges::none_of(hidden, isThis)) result.push_back(circles[i]);
  }
  return result;
}

Point centerOf(const Circle& c) { return {c.x, c.y}; }

TEST(Laws, OfPoints) {
  forEachInput(4, 400, [](const std::vector<Circle>& circles, Random&) {
    const Point a = centerOf(circles[0]), b = centerOf(circles[1]), c = centerOf(circles[2]), d = centerOf(circles[3]);
    EXPECT_EQ(orientation(a, b, c), orientation(b, c, a));
    EXPECT_EQ(orientation(a, b, c), -orientation(b, a, c));
    EXPECT_EQ(inCircle(a, b, c, d), inCircle(b, c, a, d));
    EXPECT_EQ(inCircle(a, b, c, d), inCircle(b, a, d, c));
  });
}

TEST(Laws, OfPowers) {
  forEachInput(4, 400, [](const std::vector<Circle>& circles, Random& random) {
    std::vector<WeightedPoint> points;
    for (const Circle& circle : circles) points.push_back(weightedPoint(circle, false));
    const WeightedPoint &a = points[0], &b = points[1], &c = points[2], &d = points[3];
    EXPECT_EQ(powerTest(a, b, c, d), powerTest(b, c, a, d));
    EXPECT_EQ(powerTest(a, b, c, d), powerTest(b, a, d, c));
    EXPECT_EQ(powerTest(a, b, c, d), -powerTest(b, a, c, d));
    const auto withWeight = [](const WeightedPoint& point, double weight) {
      return WeightedPoint{point.p, {weight, 0}};
    };
    EXPECT_EQ(powerTest(withWeight(a, 7), withWeight(b, 7), withWeight(c, 7), withWeight(d, 7)),
              inCircle(a.p, b.p, c.p, d.p));
    // Small integers, so that no sum is rounded.
    const std::array<double, 4> weights = {1.0 * static_cast<double>(random.below(9)), 2, -3, 0};
    const auto testWith = [&](double more) {
      return powerTest(withWeight(a, weights[0] + more), withWeight(b, weights[1] + more),
                       withWeight(c, weights[2] + more), withWeight(d, weights[3] + more));
    };
    EXPECT_EQ(testWith(0), testWith(1024));
    // Collinear: on the x axis.
    const auto onAxis = [](const WeightedPoint& point) { return WeightedPoint{{point.p.x, 0}, point.weight}; };
    if (a.p.x != b.p.x) {
      EXPECT_EQ(powerTest(onAxis(a), onAxis(b), onAxis(c)), powerTest(onAxis(b), onAxis(a), onAxis(c)));
    }
  });
}

/// All faces of some circles, which have a disc. The point at infinity is the last corner.
std::vector<exact::Face> facesOf(const std::vector<Circle>& circles) {
  std::vector<exact::Face> faces;
  for (const Circle& a : circles) {
    for (const Circle& b : circles) {
      if (&a == &b) continue;
      faces.push_back({&a, &b, nullptr});
      for (const Circle& c : circles) {
        if (&c == &a || &c == &b) continue;
        const exact::Face face = {&a, &b, &c};
        EXPECT_EQ(exact::hasDisc(face), exact::hasDisc({&b, &c, &a}));
        if (exact::hasDisc(face)) faces.push_back(face);
      }
    }
  }
  return faces;
}

bool shareAnEdge(const exact::Face& f, const exact::Face& g) {
  return std::ranges::count_if(f, [&](const Circle* c) { return std::ranges::find(g, c) != g.end(); }) >= 2;
}

TEST(Laws, OfExactSigns) {
  forEachInput(5, 20, [](const std::vector<Circle>& all, Random&) {
    for (const Circle& a : all) {
      for (const Circle& b : all) EXPECT_TRUE(!exact::contains(a, b) || !exact::contains(b, a) || a == b);
    }
    const auto circles = visible(all);
    const auto faces = facesOf(circles);
    for (const exact::Face& f : faces) {
      const Circle& o = *f[0];
      for (const exact::Face& g : faces) {
        if (g[0] != &o || !shareAnEdge(f, g)) continue;
        EXPECT_EQ(exact::crossSign(f, g, o), -exact::crossSign(g, f, o));
        if (f[2] == nullptr || g[2] == nullptr) continue;
        EXPECT_EQ(exact::crossSign(f, g, o), exact::crossSign({f[1], f[2], f[0]}, {g[2], g[0], g[1]}, o));
      }
      for (const Circle& d : circles) {
        if (std::ranges::find(f, &d) != f.end()) continue;
        EXPECT_EQ(exact::overlapSign(f, &d, o), exact::overlapSign(f, &d, *f[1]));
        EXPECT_EQ(exact::touchSign(f, &d, o), exact::touchSign(f, &d, *f[1]));
        EXPECT_TRUE(exact::overlapSign(f, &d, o) != 0 || exact::touchSign(f, &d, o) == 0);
        if (f[2] == nullptr) continue;
        EXPECT_EQ(exact::overlapSign(f, &d, o), exact::overlapSign({f[1], f[2], f[0]}, &d, *f[2]));
        EXPECT_EQ(exact::touchSign(f, &d, o), exact::touchSign({f[1], &d, f[0]}, f[2], d));
        EXPECT_EQ(exact::touchSign(f, &d, o), exact::touchSign({&d, f[2], f[1]}, f[0], *f[2]));
      }
    }
    for (const Circle& a : circles) {
      for (const Circle& b : circles) {
        for (const Circle& c : circles) {
          if (&a == &b || &b == &c || &c == &a || exact::tangentSide(a, b, c) != 0) continue;
          EXPECT_EQ(exact::touchesBetween(a, b, c), exact::touchesBetween(b, a, c));
        }
      }
    }
  });
}

/// A map of the plane under which no number is rounded, and whether it is a reflection.
struct PlaneMap {
  std::string_view name;
  Circle (*map)(const Circle&);
  bool isReflection = false;
};

constexpr std::array<PlaneMap, 5> kMaps = {{
    {"a translation",
     [](const Circle& c) {
       return Circle{c.x + 3, c.y - 5.25, c.r};
     }},
    {"a scaling",
     [](const Circle& c) {
       return Circle{0x1p-20 * c.x, 0x1p-20 * c.y, 0x1p-20 * c.r};
     }},
    {"larger radii",
     [](const Circle& c) {
       return Circle{c.x, c.y, c.r + 7.5};
     }},
    {"a quarter turn",
     [](const Circle& c) {
       return Circle{-c.y, c.x, c.r};
     }},
    {"a reflection",
     [](const Circle& c) {
       return Circle{c.y, c.x, c.r};
     },
     true},
}};

TEST(Laws, OfExactSignsUnderMapsOfThePlane) {
  forEachInput(5, 8, [](const std::vector<Circle>& all, Random&) {
    const auto circles = visible(test::onDyadicGrid(all));
    for (const PlaneMap& map : kMaps) {
      SCOPED_TRACE(map.name);
      std::vector<Circle> images;
      for (const Circle& c : circles) images.push_back(map.map(c));
      const auto imageOf = [&](const Circle* c) {
        return c == nullptr ? nullptr : &images[static_cast<std::size_t>(c - circles.data())];
      };
      const auto faceOf = [&](const exact::Face& f) {
        const auto& [a, b, c] = f;
        return map.isReflection ? exact::Face{imageOf(b), imageOf(a), imageOf(c)}
                                : exact::Face{imageOf(a), imageOf(b), imageOf(c)};
      };
      const int sense = map.isReflection ? -1 : 1;
      const auto faces = facesOf(circles);
      for (const exact::Face& f : faces) {
        EXPECT_TRUE(exact::hasDisc(faceOf(f)));
        for (const exact::Face& g : faces) {
          if (g[0] != f[0] || !shareAnEdge(f, g)) continue;
          EXPECT_EQ(exact::crossSign(faceOf(f), faceOf(g), *imageOf(f[0])), sense * exact::crossSign(f, g, *f[0]));
        }
        for (const Circle& d : circles) {
          if (std::ranges::find(f, &d) != f.end()) continue;
          EXPECT_EQ(exact::overlapSign(faceOf(f), imageOf(&d), *imageOf(f[0])), exact::overlapSign(f, &d, *f[0]));
          if (f[2] != nullptr) continue;
          const Circle& a = *faceOf(f)[0];
          const Circle& b = *faceOf(f)[1];
          EXPECT_EQ(exact::tangentSide(a, b, *imageOf(&d)), exact::tangentSide(*f[0], *f[1], d));
        }
      }
    }
  });
}

TEST(Laws, OfPredicates) {
  forEachInput(5, 30, [](const std::vector<Circle>& all, Random&) {
    const auto circles = visible(all);
    const int count = static_cast<int>(circles.size());
    Predicates predicates(circles);
    std::vector<Predicates::Triple> faces;
    for (int a = 0; a < count; ++a) {
      for (int b = 0; b < count; ++b) {
        for (int c = kPointAtInfinity; c < count; ++c) {
          if (a == b || b == c || c == a) continue;
          const FaceDisc disc = predicates.disc({a, b, c});
          const FaceDisc rotated = predicates.disc({b, c, a});
          EXPECT_EQ(disc.exists, rotated.exists);
          EXPECT_EQ(disc.isFiltered, rotated.isFiltered);
          if (!disc.isFiltered && c != kPointAtInfinity) {
            if (disc.exists) faces.push_back({a, b, c});
            continue;
          }
          EXPECT_EQ(disc, rotated);
          if (disc.exists) faces.push_back({a, b, c});
        }
      }
    }
    const auto has = [&](const Predicates::Triple& face) { return std::ranges::find(faces, face) != faces.end(); };
    for (const auto& f : faces) {
      const auto& [a, b, c] = f;
      const FaceDisc disc = predicates.disc(f);
      EXPECT_EQ(predicates.turn(a, f, disc, f, disc), 0);
      for (int d = 0; d < count; ++d) {
        const Predicates::Triple g = {b, a, d};
        if (d == c || c == kPointAtInfinity || !has(g)) continue;
        const FaceDisc other = predicates.disc(g);
        EXPECT_EQ(predicates.turn(a, f, disc, g, other), -predicates.turn(a, g, other, f, disc));
        if (circles[static_cast<std::size_t>(a)].r != circles[static_cast<std::size_t>(b)].r) continue;
        EXPECT_EQ(predicates.exactEdgeOrder(a, b, c, d), predicates.exactEdgeOrder(b, a, d, c));
      }
    }
    Predicates ofAll(all);
    for (int a = 0; a < static_cast<int>(all.size()); ++a) {
      for (int b = 0; b < a; ++b) {
        if (all[static_cast<std::size_t>(a)] == all[static_cast<std::size_t>(b)]) continue;
        EXPECT_EQ(ofAll.hiddenOf(a, b), ofAll.hiddenOf(b, a));
      }
    }
  });
}

using Line = ShiftedSigns::Line;

Line reversed(const Line& line) { return {line.to, line.from}; }

/// Corners of a region: vertices, centers, points on edges, points on one line with them, and others.
std::vector<Point> cornersAt(const Diagram& diagram, Random& random) {
  std::vector<Point> all;
  for (const Circle& c : diagram.circles) all.push_back(centerOf(c));
  for (const Vertex& v : diagram.vertices) {
    if (std::abs(v.x) + std::abs(v.y) < kCoordinateLimit) all.push_back({v.x, v.y});
  }
  const auto any = [&] { return all[random.below(all.size())]; };
  for (int k = 0; k < 6; ++k) {
    const Point p = any();
    const Point q = any();
    all.push_back({(p.x + q.x) / 2, (p.y + q.y) / 2});
  }
  for (Point& p : all) p = rounded(p);
  std::vector<Point> some;
  for (int k = 0; k < 5; ++k) {
    const Point p = any();
    if (std::ranges::find(some, p) == some.end()) some.push_back(p);
  }
  return some;
}

TEST(Laws, OfSignsOfAMovedRegion) {
  forEachInput(8, 12, [](const std::vector<Circle>& circles, Random& random) {
    const auto computed = compute(circles);
    if (!computed) return;
    const Diagram& diagram = *computed;
    const ShiftedSigns signs(diagram);
    const auto corners = cornersAt(diagram, random);
    std::vector<Line> lines;
    for (const Point p : corners) {
      for (const Point q : corners) {
        if (p != q) lines.push_back({p, q});
      }
    }
    for (const Line& line : lines) {
      for (const Point p : corners) EXPECT_EQ(signs.sideOf(p, line), -signs.sideOf(p, reversed(line)));
    }
    for (SideIndex side = 0; side < 2 * static_cast<std::int32_t>(diagram.edges.size()); ++side) {
      const SideIndex twin = Diagram::twin(side);
      const CircleIndex left = diagram.circleOf(side);
      const CircleIndex right = diagram.neighborOf(side);
      for (const Point p : corners) {
        EXPECT_EQ(signs.compare(left, right, p).sign, -signs.compare(right, left, p).sign);
        EXPECT_EQ(distanceDifference(diagram, left, right, p), -distanceDifference(diagram, right, left, p));
        for (const Point q : corners) {
          if (p == q || p == centerOf(diagram.circles[left]) || q == centerOf(diagram.circles[left])) continue;
          EXPECT_EQ(signs.turnFromRay(left, p, q), -signs.turnFromRay(left, q, p));
        }
      }
      std::vector<Line> crossing;  // those that come out of the cell of `left` into that of `right` between corners
      for (const Line& line : lines) {
        for (const bool isTarget : {false, true}) {
          if ((isTarget ? diagram.targetOf(side) : diagram.originOf(side)) == kNone) continue;
          const int sign = signs.sideOfEnd(side, isTarget, line);
          EXPECT_EQ(sign, -signs.sideOfEnd(side, isTarget, reversed(line)));
          EXPECT_EQ(sign, signs.sideOfEnd(twin, !isTarget, line));
        }
        EXPECT_EQ(signs.sideOfApex(side, line), -signs.sideOfApex(side, reversed(line)));
        EXPECT_EQ(signs.sideOfApex(side, line), signs.sideOfApex(twin, line));
        EXPECT_FALSE(signs.goesToNeighbor(side, line) && signs.goesToNeighbor(side, reversed(line)));
        EXPECT_EQ(signs.goesToNeighbor(twin, line), signs.goesToNeighbor(side, reversed(line)));
        if (signs.compare(left, right, line.from).sign > 0 && signs.compare(left, right, line.to).sign < 0) {
          crossing.push_back(line);
        }
      }
      for (const Line& l : crossing) {
        for (const Line& m : crossing) {
          const int on = signs.sideOfCrossing(left, right, l, m);
          EXPECT_EQ(on, -signs.sideOfCrossing(left, right, l, reversed(m)));
          EXPECT_EQ(on, signs.sideOfCrossing(right, left, reversed(l), m));
          // Two lines through one point of the edge cross it in one order, unless they are one line.
          if (on == 0) continue;
          EXPECT_NE(signs.isBefore(left, right, l, m), signs.isBefore(left, right, m, l));
          EXPECT_EQ(signs.isBefore(left, right, l, m), signs.isBefore(right, left, reversed(m), reversed(l)));
        }
      }
    }
  });
}

void expectLawsAtADistance(Metric metric) {
  forEachInput(8, 12, [&](const std::vector<Circle>& circles, Random& random) {
    const auto computed = compute(circles, {.metric = metric});
    if (!computed || computed->vertices.empty()) return;
    const Diagram& diagram = *computed;
    // Rims that go through vertices, up to rounding, and others.
    const Vertex& some = diagram.vertices[random.below(diagram.vertices.size())];
    const double distance = random.below(2) == 0 ? some.r : 3 * random.unit();
    if (!(std::abs(distance) < kCoordinateLimit)) return;
    const DistanceSigns signs(diagram, distance);
    const auto corners = cornersAt(diagram, random);
    for (const Edge& edge : diagram.edges) {
      EXPECT_EQ(signs.meetsRim(edge.left, RimLine::ofEdge(edge.right)),
                signs.meetsRim(edge.right, RimLine::ofEdge(edge.left)));
      for (const VertexIndex v : {edge.start, edge.end}) {
        if (v == kNone) continue;
        const ShiftedSign past = signs.pastApex(edge.left, edge.right, v);
        if (past.isTie) continue;
        EXPECT_EQ(past.sign, -signs.pastApex(edge.right, edge.left, v).sign);
      }
    }
    for (CircleIndex cell = 0; cell < static_cast<std::int32_t>(circles.size()); ++cell) {
      if (!diagram.hasCell(cell) || !signs.hasDisc(cell)) continue;
      std::vector<RimPoint> rim;
      for (const Point p : corners) {
        for (const Point q : corners) {
          if (p == q) continue;
          EXPECT_EQ(signs.meetsRim(cell, RimLine::ofSide(p, q)), signs.meetsRim(cell, RimLine::ofSide(q, p)));
          for (const Point r : {p, q, corners.front()}) {
            EXPECT_EQ(signs.pastFoot(cell, p, q, r).sign, -signs.pastFoot(cell, q, p, r).sign);
          }
          if (!signs.meetsRim(cell, RimLine::ofSide(p, q)) || std::pair(p.x, p.y) > std::pair(q.x, q.y)) continue;
          for (const bool isAhead : {false, true}) {
            rim.push_back(signs.rimPoint(cell, RimLine::ofSide(p, q), isAhead));
          }
        }
      }
      for (const RimPoint& p : rim) {
        EXPECT_FALSE(signs.isBefore(cell, p, p));
        for (const RimPoint& q : rim) {
          EXPECT_FALSE(signs.isBefore(cell, p, q) && signs.isBefore(cell, q, p));
          for (const RimPoint& r : rim) {
            EXPECT_TRUE(!signs.isBefore(cell, p, q) || !signs.isBefore(cell, q, r) || signs.isBefore(cell, p, r));
          }
        }
      }
    }
  });
}

TEST(Laws, OfSignsAtADistance) { expectLawsAtADistance(Metric::circles); }
TEST(Laws, OfSignsAtADistanceInPowerDiagrams) { expectLawsAtADistance(Metric::power); }

}  // namespace
}  // namespace laws_test
}  // namespace circle_voronoi
