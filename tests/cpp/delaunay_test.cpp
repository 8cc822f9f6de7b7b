// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "circle_voronoi_families/families.h"
#include "fixtures.h"
#include "oracle.h"
#include "random.h"
#include "report.h"
#include "tie_inputs.h"

namespace circle_voronoi {
namespace {

using Points = std::vector<Point>;
using Faces = std::vector<std::array<int, 3>>;

Points centersOf(const std::vector<Circle>& circles) {
  Points points;
  for (const Circle& c : circles) points.push_back({c.x, c.y});
  return points;
}

/// The faces, each beginning with its smallest corner, sorted.
Faces facesOf(const Dual& dual) {
  Faces faces;
  for (int h = 0; h < dual.halfEdgeCount(); h += 3) {
    faces.push_back({dual.origin[h], dual.origin[h + 1], dual.origin[h + 2]});
    std::rotate(faces.back().begin(), std::min_element(faces.back().begin(), faces.back().end()), faces.back().end());
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// Twins fit, faces are in order, every point has its representative.
void expectSound(const Delaunay& triangulation, const Points& points) {
  const Dual& dual = triangulation.dual;
  ASSERT_EQ(dual.twin.size(), dual.origin.size());
  for (int h = 0; h < dual.halfEdgeCount(); ++h) {
    ASSERT_EQ(dual.twin[dual.twin[h]], h);
    ASSERT_EQ(dual.origin[dual.twin[h]], dual.target(h));
  }
  int last = kPointAtInfinity;
  for (int h = 0; h < dual.halfEdgeCount(); h += 3) {
    const int smallest = std::min({dual.origin[h], dual.origin[h + 1], dual.origin[h + 2]});
    ASSERT_GE(smallest, last);
    last = smallest;
  }
  std::map<std::pair<double, double>, int> first;
  ASSERT_EQ(triangulation.representative.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int expected = first.emplace(std::pair(points[i].x, points[i].y), static_cast<int>(i)).first->second;
    ASSERT_EQ(triangulation.representative[i], expected);
  }
}

void expectAsByCgal(const Points& points) {
  const Delaunay actual = delaunay(points);
  expectSound(actual, points);
  const Faces faces = facesOf(actual.dual);
  ASSERT_EQ(faces, oracle::delaunayFaces(points));

  const DelaunayEdges graph = delaunayEdges(points);
  EXPECT_EQ(graph.representative, actual.representative);
  std::set<std::pair<int, int>> edges;
  for (const auto& [a, b] : graph.edges) {
    EXPECT_TRUE(edges.emplace(std::min(a, b), std::max(a, b)).second) << a << " " << b << " twice";
  }
  std::set<std::pair<int, int>> expected;
  for (const auto& face : faces) {
    for (int i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(face[i], face[(i + 1) % 3]);
      if (a != kPointAtInfinity) expected.emplace(a, b);
    }
  }
  EXPECT_EQ(edges, expected);
}

TEST(Delaunay, IsThatOfCgalForFewPoints) {
  for (const Points& points : std::vector<Points>{{},
                                                  {{1, 2}},
                                                  {{1, 2}, {1, 2}, {1, 2}},
                                                  {{3, 0}, {1, 0}},
                                                  {{0, 3}, {0, 1}, {0, 3}, {0, 3}},
                                                  {{0, 0}, {5, 1}, {2, 7}},
                                                  {{0, 0}, {2, 2}, {1, 1}},
                                                  {{0, 0}, {4, 0}, {1, 0}, {2, 0}, {3, 1}},
                                                  {{0, 0}, {1, 0}, {0, 1}, {1, 1}}}) {
    expectAsByCgal(points);
  }
}

TEST(Delaunay, IsThatOfCgalForEveryFamily) {
  for (const FamilyInfo& info : families()) {
    SCOPED_TRACE(info.name);
    for (const std::size_t count : {2U, 3U, 5U, 17U, 100U, 2000U}) {
      expectAsByCgal(centersOf(generate(info.family, count, count)));
    }
  }
}

TEST(Delaunay, IsThatOfCgalForFixtures) {
  for (const std::string& name : test::fixtureNames()) {
    SCOPED_TRACE(name);
    expectAsByCgal(centersOf(test::readFixture(name)));
  }
}

TEST(Delaunay, IsThatOfCgalForExactTies) {
  const std::uint64_t seed = test::seedOr(1);
  Random random(seed);
  for (const test::TieKind& kind : test::tieKinds()) {
    SCOPED_TRACE(kind.name);
    for (int disturbance = 0; disturbance < test::kDisturbances; ++disturbance) {
      for (const std::size_t count : {4U, 9U, 60U}) {
        std::vector<Circle> circles = kind.make(count, random);
        test::disturb(circles, static_cast<test::Disturbance>(disturbance), random);
        expectAsByCgal(centersOf(circles));
      }
    }
  }
}

// Many equal, collinear and co-circular points.
TEST(Delaunay, IsThatOfCgalForSmallGrids) {
  const std::uint64_t seed = test::seedOr(1);
  Random random(seed);
  for (int round = 0; round < 3000; ++round) {
    const std::size_t width = 1 + random.below(6);
    const std::size_t height = 1 + random.below(12);
    const double step = random.below(2) == 0 ? 1 : 0.1;
    Points points(1 + random.below(60));
    for (Point& p : points) {
      p = {step * static_cast<double>(random.below(width)), step * static_cast<double>(random.below(height))};
    }
    expectAsByCgal(points);
    if (HasFatalFailure()) return;
  }
}

TEST(Delaunay, DoesNotDependOnTheOrder) {
  const std::uint64_t seed = test::seedOr(1);
  Random random(seed);
  const Points points = centersOf(generate(Family::grid, 400, seed));
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  Points shuffled;
  for (const int i : order) shuffled.push_back(points[i]);
  Delaunay triangulation = delaunay(shuffled);
  for (int& corner : triangulation.dual.origin) corner = corner == kPointAtInfinity ? kPointAtInfinity : order[corner];
  EXPECT_EQ(facesOf(triangulation.dual), facesOf(delaunay(points).dual));
}

struct Distribution {
  std::string name;
  std::function<Point(double, Random&)> pointAt;  ///< at a number in [0, 1)
};

// Points that other ways walk or search long for: on curves, in far clusters, with an outlier, on one another.
const std::vector<Distribution>& hostileOnes() {
  static const std::vector<Distribution> all = {
      {"circle",
       [](double t, Random&) {
         const Vector v = directionAt(t);
         return Point{v.x, v.y};
       }},
      {"parabola",
       [](double t, Random&) {
         return Point{t, t * t};
       }},
      {"line",
       [](double t, Random&) {
         return Point{t, 0};
       }},
      {"two lines",
       [](double, Random& random) {
         return Point{random.unit(), static_cast<double>(random.below(2))};
       }},
      {"steep exponential",
       [](double t, Random& random) {
         return Point{powerOfTen(20 * t), random.unit()};
       }},
      {"two far clusters",
       [](double, Random& random) {
         return Point{random.unit() + 1e12 * static_cast<double>(random.below(2)), random.unit()};
       }},
      {"twenty far clusters",
       [](double, Random& random) {
         const auto k = static_cast<double>(random.below(20));
         return Point{random.unit() + 1e6 * k, random.unit() + 1e6 * k * k};
       }},
      {"outlier",
       [](double t, Random& random) {
         return Point{t == 0 ? 1e9 : random.unit(), random.unit()};
       }},
      {"few places",
       [](double, Random& random) {
         return Point{static_cast<double>(random.below(5)), static_cast<double>(random.below(5))};
       }},
      {"grid",
       [](double, Random& random) {
         return Point{static_cast<double>(random.below(300)), static_cast<double>(random.below(300))};
       }},
      {"half in one place",
       [](double, Random& random) {
         return random.below(2) == 0 ? Point{} : Point{random.unit(), random.unit()};
       }},
  };
  return all;
}

Points pointsOf(const Distribution& distribution, int count, Random& random) {
  Points points;
  for (int i = 0; i < count; ++i) points.push_back(distribution.pointAt(static_cast<double>(i) / count, random));
  for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[random.below(i)]);
  return points;
}

TEST(Delaunay, IsThatOfCgalForHostilePoints) {
  const std::uint64_t seed = test::seedOr(1);
  Random random(seed);
  for (const Distribution& distribution : hostileOnes()) {
    SCOPED_TRACE(distribution.name);
    for (const int count : {10, 100, 1000}) expectAsByCgal(pointsOf(distribution, count, random));
  }
}

TEST(Delaunay, TakesNLogNSteps) {
  const std::uint64_t seed = test::seedOr(1);
  Random random(seed);
  for (const Distribution& distribution : hostileOnes()) {
    SCOPED_TRACE(distribution.name);
    for (const int count : {1000, 100000}) {
      const Delaunay triangulation = delaunay(pointsOf(distribution, count, random));
      EXPECT_LT(static_cast<double>(triangulation.steps), 3 * count * std::log2(count)) << count << " points";
    }
  }
}

}  // namespace
}  // namespace circle_voronoi
