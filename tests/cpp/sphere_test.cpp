// SPDX-License-Identifier: GPL-3.0-or-later
// Circles on a sphere, compared with 50 digits, with brute force and with what is known of regular families.
#include "circle_voronoi/sphere.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "at.h"
#include "circle_voronoi/region.h"
#include "elementary.h"
#include "random.h"
#include "sphere_oracle.h"

namespace circle_voronoi {
namespace {

using test::CapInput;

double sphereArea(const SphereDiagram& diagram) { return 4 * kPi * diagram.radius * diagram.radius; }

double sumOf(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum;
}

std::size_t visibleCount(const SphereDiagram& diagram) { return diagram.caps.size() - diagram.hidden.size(); }

/// A random place, uniform on the sphere.
Point randomPlace(Random& random) { return {random.uniform(-180, 180), std::asin(random.uniform(-1, 1)) / kDegree}; }

/// The distance of a place from the nearest cap.
double nearestDistance(const SphereDiagram& diagram, Point p) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < diagram.caps.size(); ++i) {
    best = std::min(best, distanceFrom(diagram, static_cast<std::int32_t>(i), p.x, p.y));
  }
  return best;
}

SphereDiagram computed(const std::vector<Cap>& caps, const SphereOptions& options = {}) {
  auto diagram = computeSphere(caps, options);
  EXPECT_TRUE(diagram) << diagram.error().message;
  return diagram ? *std::move(diagram) : SphereDiagram{};
}

/// Twice the area of a ring in the plane of degrees.
double doubleArea(std::span<const Point> ring) {
  double sum = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point p = ring[k];
    const Point q = ring[(k + 1) % ring.size()];
    sum += (p.x - ring[0].x) * (q.y - ring[0].y) - (q.x - ring[0].x) * (p.y - ring[0].y);
  }
  return sum;
}

/// The rings of one row of polygons.
std::vector<std::vector<Point>> ringsOf(const ClippedPolygons& polygons, std::size_t row) {
  std::vector<std::vector<Point>> rings;
  const auto ringAt = [&](std::int32_t polygon) { return polygons.ringOffsets[at(polygon)]; };
  for (std::int32_t r = ringAt(polygons.polygonOffsets[row]); r < ringAt(polygons.polygonOffsets[row + 1]); ++r) {
    rings.emplace_back(polygons.points.begin() + polygons.pointOffsets[at(r)],
                       polygons.points.begin() + polygons.pointOffsets[at(r) + 1]);
  }
  return rings;
}

/// The polygons of one row, each a list of rings.
std::vector<std::vector<std::vector<Point>>> polygonsOf(const ClippedPolygons& polygons, std::size_t row) {
  std::vector<std::vector<std::vector<Point>>> result;
  const auto rings = ringsOf(polygons, row);
  const std::int32_t first = polygons.ringOffsets[at(polygons.polygonOffsets[row])];
  for (std::int32_t k = polygons.polygonOffsets[row]; k < polygons.polygonOffsets[row + 1]; ++k) {
    result.emplace_back(rings.begin() + (polygons.ringOffsets[at(k)] - first),
                        rings.begin() + (polygons.ringOffsets[at(k) + 1] - first));
  }
  return result;
}

/// Whether a point lies inside an odd number of rings.
bool isInside(const std::vector<std::vector<Point>>& rings, Point p) {
  bool inside = false;
  for (const auto& ring : rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point a = ring[k];
      const Point b = ring[(k + 1) % ring.size()];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
  }
  return inside;
}

/// Expects polygons as RFC 7946 wants them, which cover each place once and with the cell that it belongs to, but for
/// `doubt` square degrees.
void expectPolygons(const SphereDiagram& diagram, double tolerance, double doubt = 1e-7) {
  SpherePolygonOptions options;
  options.tolerance = tolerance;
  const auto polygons = cellPolygons(diagram, options);
  ASSERT_TRUE(polygons) << polygons.error().message;
  ASSERT_EQ(polygons->polygonOffsets.size(), diagram.caps.size() + 1);
  double total = 0;
  std::vector<std::vector<std::vector<Point>>> rows;
  for (std::size_t i = 0; i < diagram.caps.size(); ++i) {
    rows.push_back(ringsOf(*polygons, i));
    for (std::int32_t k = polygons->polygonOffsets[i]; k < polygons->polygonOffsets[i + 1]; ++k) {
      for (std::int32_t r = polygons->ringOffsets[at(k)]; r < polygons->ringOffsets[at(k) + 1]; ++r) {
        const auto ring = std::span(polygons->points)
                              .subspan(at(polygons->pointOffsets[at(r)]),
                                       at(polygons->pointOffsets[at(r) + 1] - polygons->pointOffsets[at(r)]));
        ASSERT_GE(ring.size(), 3u);
        const double area = doubleArea(ring);
        EXPECT_EQ(area > 0, r == polygons->ringOffsets[at(k)]) << "cap " << i;
        total += area / 2;
        for (const Point p : ring) {
          ASSERT_LE(std::abs(p.x), 180);
          ASSERT_LE(std::abs(p.y), 90);
        }
      }
    }
    if (rows.back().empty()) {
      EXPECT_LE(area(diagram, static_cast<std::int32_t>(i)), 1e-9 * tolerance * tolerance) << "cap " << i;
    } else {
      EXPECT_TRUE(diagram.hasCell(static_cast<std::int32_t>(i)));
      const auto valid = Region::fromPolygons(polygonsOf(*polygons, i));
      EXPECT_TRUE(valid) << "cap " << i << ": " << valid.error().message;
    }
  }
  // Borders share their points, so that nothing is missing.
  EXPECT_NEAR(total, 360 * 180, doubt);
  Random random(5);
  for (int trial = 0; trial < 100; ++trial) {
    const Point p = randomPlace(random);
    const double best = nearestDistance(diagram, p);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double distance = distanceFrom(diagram, static_cast<std::int32_t>(i), p.x, p.y);
      if (isInside(rows[i], p)) {
        EXPECT_LE(distance, best + 2 * tolerance) << "cap " << i << " at " << p.x << " " << p.y;
      }
    }
  }
}

/// Expects a diagram that is right by all means that we have.
void expectRight(const CapInput& input) {
  SCOPED_TRACE(input.name);
  const auto diagram = computeSphere(input.caps, input.options);
  ASSERT_TRUE(diagram) << diagram.error().message << "\n" << test::describe(input.caps);
  EXPECT_TRUE(checkSphere(*diagram));
  const std::size_t visible = visibleCount(*diagram);
  EXPECT_EQ(diagram->vertices.size(), visible < 3 ? 0 : 2 * visible - 4);
  const test::SphereErrors errors = test::errorsOf(*diagram);
  EXPECT_LE(errors.reach, 0) << errors.message << "\n" << test::describe(input.caps);
  EXPECT_LE(errors.touch, std::max(1e-14, 6 * diagram->rounding / diagram->radius)) << test::describe(input.caps);
  EXPECT_LE(errors.distance, 1e-12) << errors.message << "\n" << test::describe(input.caps);
  const std::vector<double> all = areas(*diagram);
  if (!input.caps.empty()) {
    EXPECT_NEAR(sumOf(all) / sphereArea(*diagram), 1, 1e-12) << test::describe(input.caps);
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_GE(all[i], diagram->hasCell(static_cast<std::int32_t>(i)) ? -1e-15 * sphereArea(*diagram) : 0);
  }
  const SphereFinder finder(*diagram);
  Random random(3);
  for (int trial = 0; trial < 30; ++trial) {
    const Point p = randomPlace(random);
    const CircleIndex found = finder.find(p.x, p.y);
    if (input.caps.empty()) {
      EXPECT_EQ(found, kNone);
    } else {
      EXPECT_LE(distanceFrom(*diagram, found, p.x, p.y), nearestDistance(*diagram, p) + 1e-14 * diagram->radius);
    }
  }
}

std::vector<CapInput> families() {
  std::vector<CapInput> inputs;
  const auto add = [&](const std::string& name, std::vector<Cap> caps) {
    inputs.push_back({name, std::move(caps), {}});
  };
  const auto ring = [](int count, double latitude, double r) {
    std::vector<Cap> caps;
    for (int k = 0; k < count; ++k) caps.push_back({360.0 * k / count, latitude, r});
    return caps;
  };
  const double degree = kEarthRadius * kDegree;
  add("none", {});
  add("one", {{12, 34, 100}});
  add("two", {{12, 34, 100}, {50, -10, 3000}});
  add("antipodal points", {{12, 34, 0}, {-168, -34, 0}});
  add("two poles", {{0, 90, 0}, {0, -90, 1000}});
  add("three", {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}});
  add("three on the equator", ring(3, 0, 0));
  add("octahedron", {{0, 0, 0}, {90, 0, 0}, {180, 0, 0}, {-90, 0, 0}, {0, 90, 0}, {0, -90, 0}});
  std::vector<Cap> cube = ring(4, 35.264389682754654, 0);
  for (const Cap& cap : ring(4, -35.264389682754654, 0)) cube.push_back(cap);
  add("cube", cube);
  add("equator", ring(12, 0, 0));
  add("equator with weights that alternate", [&] {
    auto caps = ring(12, 0, 0);
    for (std::size_t k = 0; k < caps.size(); k += 2) caps[k].r = 500;
    return caps;
  }());
  std::vector<Cap> meridian;
  for (int k = 0; k < 9; ++k) meridian.push_back({20, -80 + 20.0 * k, 0});
  add("meridian", meridian);
  std::vector<Cap> antimeridian = meridian;
  for (Cap& cap : antimeridian) cap.longitude = 180;
  add("antimeridian", antimeridian);
  std::vector<Cap> grid = {{7, 90, 0}, {-33, -90, 0}};
  for (int x = 0; x < 36; ++x) {
    for (int y = -8; y <= 8; ++y) grid.push_back({10.0 * x - 175, 10.0 * y, 0});
  }
  add("grid of degrees with poles", grid);
  for (std::size_t k = 0; k < grid.size(); ++k) grid[k].r = degree * static_cast<double>(k % 3);
  add("grid of caps with poles", grid);
  add("tangent caps", ring(12, 0, 15 * degree));
  add("tangent from inside", {{0, 0, 10 * degree}, {8, 0, 2 * degree}, {0, 6, 4 * degree}, {40, 0, 0}, {0, -50, 0}});
  add("larger than half of the sphere",
      {{0, 0, 120 * degree}, {90, 0, 100 * degree}, {200, 40, 95 * degree}, {0, -80, 0}});
  add("one hides all", {{0, 0, 170 * degree}, {10, 0, 10}, {-60, 20, 100}, {90, 45, 0}});
  add("duplicates", {{10, 10, 5}, {370, 10, 5}, {10, 10, 5}, {10, 10, 4}, {-50, 0, 0}, {-50, 0, 0}, {120, -30, 0}});
  add("poles with any longitude", {{10, 90, 5}, {370, 90, 5}, {-77, 90, 5}, {0, -90, 3}, {90, -90, 3}, {30, 0, 0}});
  add("over the antipode", {{0, 0, 0}, {180, 0, 60 * degree}, {170, 20, 30 * degree}, {-170, -20, 30 * degree}});
  std::vector<Cap> tiny;
  Random random(8);
  for (int k = 0; k < 40; ++k) {
    tiny.push_back({24 + random.uniform(0, 1e-8), 60 + random.uniform(0, 5e-9), random.uniform(0, 1e-7)});
  }
  add("within a millimeter", tiny);
  tiny.resize(36);
  tiny.push_back({-156, -60, 0});
  add("within a millimeter, and one opposite", tiny);
  add("a vertex opposite three nearby points", {{10.00000000858517, 20.000000005874586, 0},
                                                {10.00000000982261, 20.00000000120966, 0},
                                                {10.000000005983424, 20.000000009586113, 0}});
  std::vector<Cap> hemisphere;
  for (int k = 0; k < 60; ++k) hemisphere.push_back({random.uniform(-60, 60), random.uniform(-60, 60), 0});
  add("within a hemisphere", hemisphere);
  return inputs;
}

TEST(Sphere, FamiliesAreRight) {
  for (const CapInput& input : families()) expectRight(input);
}

TEST(Sphere, FamiliesHaveTheVisibleCapsThatAreKnown) {
  const std::map<std::string, std::size_t> known = {{"octahedron", 6},
                                                    {"cube", 8},
                                                    {"grid of degrees with poles", 614},
                                                    {"one hides all", 1},
                                                    {"duplicates", 3},
                                                    {"poles with any longitude", 3},
                                                    {"tangent caps", 12},
                                                    {"antipodal points", 2},
                                                    {"within a hemisphere", 60}};
  std::size_t met = 0;
  for (const CapInput& input : families()) {
    const auto found = known.find(input.name);
    if (found == known.end()) continue;
    ++met;
    EXPECT_EQ(visibleCount(computed(input.caps)), found->second) << input.name;
  }
  EXPECT_EQ(met, known.size());
}

TEST(Sphere, PolygonsCoverTheSphereOnce) {
  for (const CapInput& input : families()) {
    if (input.caps.empty() || input.name == "within a millimeter") continue;
    SCOPED_TRACE(input.name);
    expectPolygons(computed(input.caps), 5);
  }
}

int trials() {
  const char* text = std::getenv("CIRCLE_VORONOI_SPHERE_TRIALS");
  return text == nullptr ? 150 : std::atoi(text);
}

TEST(Sphere, RandomCapsAreRight) {
  for (int trial = 0; trial < trials() && !testing::Test::HasFailure(); ++trial) {
    expectRight(test::randomCaps(static_cast<std::uint64_t>(trial)));
  }
}

// Three caps lie in nearly the same direction from a vertex, or opposite to it, so that it depends on their last bits.
// Without a look at the caps around it, cells that are wrong there were accepted.
TEST(Sphere, CapsBesideAnIllConditionedVertexAreRightOrRefused) {
  for (const std::uint64_t seed : {4518, 24015, 48597}) {
    const CapInput input = test::randomCaps(seed);
    if (computeSphere(input.caps, input.options)) expectRight(input);
  }
}

// A cap nearly hides another, so that their border has fewer digits.
TEST(Sphere, VerticesTouchCapsThatNearlyHideOneAnother) {
  for (const std::uint64_t seed : {81090, 124377, 229720}) expectRight(test::randomCaps(seed));
}

// Two caps are at the same place up to the rounding of their degrees. No distance tells which of the two is nearer, so
// that a walk that wants to come nearer stops at the one that is not a neighbor of the right cap.
TEST(Sphere, FindsPlacesBeyondCapsAtNearlyTheSamePlace) {
  for (const std::uint64_t seed : {13903, 27607, 46027}) expectRight(test::randomCaps(seed));
}

// Seen from a third cap, two are at the same place up to rounding. The direction of their vertex is then that of its
// degrees.
TEST(Sphere, AreasBesideCapsAtNearlyTheSamePlaceFillTheSphere) { expectRight(test::randomCaps(188616)); }

// The distance of one vertex has eleven digits only, as it magnifies errors of its caps ten times.
TEST(Sphere, DistancesHaveTheDigitsOfTheirCaps) { expectRight(test::randomCaps(17133)); }

TEST(Sphere, RandomPolygonsCoverTheSphereOnce) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const CapInput input = test::randomCaps(seed);
    if (input.caps.empty()) continue;
    SCOPED_TRACE(input.name + " of seed " + std::to_string(seed));
    const SphereDiagram diagram = computed(input.caps, input.options);
    for (const double tolerance : {1e-5, 1e-3, 0.1}) {
      // Rings of cells that are narrower than the tolerance may be divided.
      expectPolygons(diagram, tolerance * diagram.radius, 2 * tolerance / kDegree);
    }
  }
}

TEST(Sphere, VerticesAreThoseOfTheOctahedron) {
  const SphereDiagram diagram = computed(families()[7].caps);
  ASSERT_EQ(diagram.vertices.size(), 8u);
  for (const SphereVertex& v : diagram.vertices) {
    EXPECT_NEAR(std::abs(v.latitude), 35.264389682754654, 1e-13);
    EXPECT_NEAR(std::abs(std::remainder(v.longitude, 90)), 45, 1e-13);
    EXPECT_NEAR(v.distance / kEarthRadius, std::acos(1 / std::sqrt(3)), 1e-15);
  }
  for (const double area : areas(diagram)) EXPECT_NEAR(area / sphereArea(diagram), 1.0 / 6, 1e-15);
  for (CircleIndex i = 0; i < 6; ++i) {
    // Each side is an eighth of the three great circles between the axes.
    EXPECT_NEAR(perimeter(diagram, i) / kEarthRadius, 4 * std::acos(1.0 / 3), 1e-13);
    EXPECT_EQ(neighbors(diagram, i).size(), 4u);
  }
}

TEST(Sphere, NeighborsGoAroundCounterClockwise) {
  const SphereDiagram diagram = computed({{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {-10, 0, 0}, {0, -10, 0}});
  std::vector<CircleIndex> around = neighbors(diagram, 0);
  std::ranges::rotate(around, std::ranges::find(around, CircleIndex(1)));
  EXPECT_EQ(around, (std::vector<CircleIndex>{1, 2, 3, 4}));
}

TEST(Sphere, TheOrderOfCapsDoesNotMatter) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const CapInput input = test::randomCaps(seed);
    const SphereDiagram diagram = computed(input.caps, input.options);
    const std::vector<Cap> reversed(input.caps.rbegin(), input.caps.rend());
    const SphereDiagram other = computed(reversed, input.options);
    const auto sorted = [](const SphereDiagram& d) {
      std::vector<std::array<double, 3>> vertices;
      for (const SphereVertex& v : d.vertices) vertices.push_back({v.longitude, v.latitude, v.distance});
      std::ranges::sort(vertices);
      return vertices;
    };
    EXPECT_EQ(sorted(diagram), sorted(other)) << input.name;
  }
}

TEST(Sphere, ThreadsDoNotChangeABit) {
  std::vector<Cap> caps;
  Random random(2);
  for (int k = 0; k < 5000; ++k) {
    const Point p = randomPlace(random);
    caps.push_back({p.x, p.y, random.uniform(0, 100)});
  }
  SphereOptions options;
  const SphereDiagram one = computed(caps, options);
  options.threads = 4;
  const SphereDiagram four = computed(caps, options);
  EXPECT_EQ(one.vertices, four.vertices);
  EXPECT_EQ(one.edges, four.edges);
  EXPECT_EQ(one.links, four.links);
}

TEST(Sphere, OnlyDifferencesOfWeightsMatter) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CapInput input = test::randomCaps(seed);
    input.options = {.radius = 1, .weights = true, .threads = 1};
    for (Cap& cap : input.caps) cap.r = std::round(cap.r / kEarthRadius * 0x1p20) / 0x1p20 / 4;
    const SphereDiagram diagram = computed(input.caps, input.options);
    for (Cap& cap : input.caps) cap.r -= 0.5;
    const SphereDiagram other = computed(input.caps, input.options);
    ASSERT_EQ(diagram.vertexCaps, other.vertexCaps) << input.name;
    EXPECT_EQ(diagram.edges, other.edges);
    for (std::size_t v = 0; v < diagram.vertices.size(); ++v) {
      EXPECT_EQ(diagram.vertices[v].longitude, other.vertices[v].longitude);
      EXPECT_EQ(diagram.vertices[v].latitude, other.vertices[v].latitude);
      EXPECT_NEAR(diagram.vertices[v].distance + 0.5, other.vertices[v].distance, 1e-15);
    }
  }
}

TEST(Sphere, ErrorsNameTheCap) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto codeOf = [](Cap cap, const SphereOptions& options = {}) {
    const auto result = computeSphere(std::vector<Cap>{{1, 2, 3}, cap}, options);
    EXPECT_FALSE(result);
    EXPECT_EQ(result.error().circle, 1);
    EXPECT_NE(result.error().message.find("Cap 1"), std::string::npos);
    return result.error().code;
  };
  EXPECT_EQ(codeOf({nan, 0, 0}), ErrorCode::nonFinite);
  EXPECT_EQ(codeOf({0, nan, 0}), ErrorCode::nonFinite);
  EXPECT_EQ(codeOf({0, 0, nan}), ErrorCode::nonFinite);
  EXPECT_EQ(codeOf({0, 90.1, 0}), ErrorCode::coordinateTooLarge);
  EXPECT_EQ(codeOf({0, 0, -1}), ErrorCode::negativeRadius);
  EXPECT_EQ(codeOf({0, 0, kPi * kEarthRadius}), ErrorCode::coordinateTooLarge);
  EXPECT_EQ(codeOf({0, 0, 4}, {.radius = 1, .weights = false, .threads = 1}), ErrorCode::coordinateTooLarge);
  for (const double radius : {0.0, -1.0, nan, 1e30}) {
    const auto result = computeSphere({}, {.radius = radius, .weights = false, .threads = 1});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::badOption);
  }
  EXPECT_EQ(computeSphere({}, {.radius = 1, .weights = false, .threads = -1}).error().code, ErrorCode::badOption);
  SpherePolygonOptions options;
  options.tolerance = 0;
  EXPECT_EQ(cellPolygons(computed({{0, 0, 0}}), options).error().code, ErrorCode::badOption);
}

TEST(Sphere, AMaximumDistanceCutsCells) {
  Random random(4);
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const CapInput input = test::randomCaps(seed);
    const SphereDiagram diagram = computed(input.caps, input.options);
    const double distance = diagram.radius * random.uniform(0, 1);
    const auto cut = areas(diagram, distance);
    const auto whole = areas(diagram);
    double expected = 0;
    constexpr int kPlaces = 2000;
    for (int k = 0; k < kPlaces; ++k) {
      expected += nearestDistance(diagram, randomPlace(random)) <= distance ? 1.0 / kPlaces : 0;
    }
    // Five standard deviations.
    EXPECT_NEAR(sumOf(cut) / sphereArea(diagram), expected, 5 * 0.5 / std::sqrt(kPlaces)) << input.name;
    for (std::size_t i = 0; i < cut.size(); ++i) EXPECT_LE(cut[i], whole[i] + 1e-13 * sphereArea(diagram));
  }
  const SphereDiagram one = computed({{30, 40, 100}});
  EXPECT_NEAR(area(one, 0, 900), 2 * kPi * kEarthRadius * kEarthRadius * (1 - std::cos(1000 / kEarthRadius)), 1e-3);
  EXPECT_NEAR(perimeter(one, 0, 900), 2 * kPi * kEarthRadius * std::sin(1000 / kEarthRadius), 1e-8);
  EXPECT_EQ(area(one, 0, -200), 0);
  EXPECT_NEAR(area(one, 0, 20000), sphereArea(one), 1e-6);
}

TEST(Sphere, PolygonsWithAMaximumDistanceEndThere) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const CapInput input = test::randomCaps(seed);
    const SphereDiagram diagram = computed(input.caps, input.options);
    for (const double share : {0.1, 0.6, 2.0}) {
      SpherePolygonOptions options;
      options.maxDistance = share * diagram.radius;
      options.tolerance = 1e-3 * diagram.radius;
      const auto polygons = cellPolygons(diagram, options);
      ASSERT_TRUE(polygons);
      Random random(9);
      for (int k = 0; k < 50; ++k) {
        const Point p = randomPlace(random);
        int count = 0;
        for (std::size_t i = 0; i < diagram.caps.size(); ++i) count += isInside(ringsOf(*polygons, i), p) ? 1 : 0;
        const double distance = nearestDistance(diagram, p);
        // Near a border, rounding decides.
        const bool isNearBorder = std::abs(distance - *options.maxDistance) < 3e-3 * diagram.radius;
        if (isNearBorder) continue;
        if (distance > *options.maxDistance) {
          EXPECT_EQ(count, 0) << input.name << " " << share << " " << p.x << " " << p.y;
        } else {
          EXPECT_EQ(count, 1) << input.name << " " << share << " " << p.x << " " << p.y;
        }
      }
    }
  }
}

TEST(Sphere, ThePoleIsInsideThePolygonOfItsCell) {
  const SphereDiagram diagram = computed({{0, -90, 0}, {106.84, -78.46, 0}, {123.33, -75.10, 0}, {166.67, -77.85, 0}});
  const auto polygons = cellPolygons(diagram);
  ASSERT_TRUE(polygons);
  const auto rings = ringsOf(*polygons, 0);
  ASSERT_FALSE(rings.empty());
  EXPECT_TRUE(isInside(rings, {-90, -89.9999}));
  EXPECT_TRUE(isInside(rings, {-90, 60}));
  EXPECT_FALSE(isInside(rings, {106.84, -78.46}));
  EXPECT_NE(std::ranges::find(rings[0], Point{-180, -90}), rings[0].end());
  EXPECT_NE(std::ranges::find(rings[0], Point{180, -90}), rings[0].end());
}

TEST(Sphere, WorldCitiesHaveTheCellsOfTheGlobe) {
  // Juneau, Saint Petersburg, Melbourne.
  const SphereDiagram diagram = computed({{-134.42, 58.30, 0}, {30.31, 59.94, 0}, {144.96, -37.81, 0}});
  const auto polygons = cellPolygons(diagram);
  ASSERT_TRUE(polygons);
  Random random(6);
  for (int k = 0; k < 500; ++k) {
    const Point p = randomPlace(random);
    const double best = nearestDistance(diagram, p);
    for (std::size_t i = 0; i < 3; ++i) {
      const double distance = distanceFrom(diagram, static_cast<std::int32_t>(i), p.x, p.y);
      if (std::abs(distance - best) > 0 && distance - best < 1) continue;
      EXPECT_EQ(isInside(ringsOf(*polygons, i), p), distance == best) << i << " " << p.x << " " << p.y;
    }
  }
}

TEST(Sphere, NoPlaceIsFartherThanTheFarthest) {
  Random random(12);
  int edges = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    CapInput input = test::randomCaps(seed);
    const bool isHemisphere = seed % 2 == 0;
    if (isHemisphere) {
      for (Cap& cap : input.caps) cap = {random.uniform(-50, 50), random.uniform(-50, 50), 0};
    }
    const SphereDiagram diagram = computed(input.caps, input.options);
    const auto farthest = farthestPlace(diagram);
    ASSERT_TRUE(farthest);
    const auto& [place, caps] = *farthest;
    EXPECT_NEAR(nearestDistance(diagram, {place.longitude, place.latitude}), place.distance, 1e-13 * diagram.radius)
        << input.name;
    for (int k = 0; k < 300; ++k) {
      ASSERT_LE(nearestDistance(diagram, randomPlace(random)), place.distance + 1e-13 * diagram.radius) << input.name;
    }
    edges += caps[1] != kNone && caps[2] == kNone && visibleCount(diagram) > 2 ? 1 : 0;
  }
  EXPECT_GT(edges, 10);
  const auto opposite = farthestPlace(computed({{10, 20, 50}}));
  ASSERT_TRUE(opposite);
  EXPECT_EQ(opposite->place, (SphereVertex{-170, -20, kPi * kEarthRadius - 50}));
  EXPECT_FALSE(farthestPlace(computed({})));
}

TEST(Sphere, NoPairIsCloserThanTheClosest) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const CapInput input = test::randomCaps(seed);
    const SphereDiagram diagram = computed(input.caps, input.options);
    const auto closest = closestPair(diagram);
    ASSERT_EQ(closest.has_value(), visibleCount(diagram) > 1);
    if (!closest) continue;
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < diagram.caps.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (!diagram.hasCell(static_cast<std::int32_t>(i)) || !diagram.hasCell(static_cast<std::int32_t>(j))) continue;
        const Cap& c = diagram.caps[i];
        best = std::min(best, distanceFrom(diagram, static_cast<std::int32_t>(j), c.longitude, c.latitude) - c.r);
      }
    }
    EXPECT_NEAR(closest->gap, best, 1e-15 * diagram.radius) << input.name;
  }
}

TEST(Sphere, AreasOfSmallCellsHaveAllTheirDigits) {
  // A square of nine points: the cell in the middle has the side of the grid.
  for (const double step : {1e-2, 1e-5, 1e-8}) {
    std::vector<Cap> caps;
    for (int x = -1; x <= 1; ++x) {
      for (int y = -1; y <= 1; ++y) caps.push_back({x * step, y * step, 0});
    }
    const SphereDiagram diagram = computed(caps);
    const double side = step * kDegree * kEarthRadius;
    EXPECT_NEAR(area(diagram, 4) / (side * side), 1, 1e-13 + step * step * kDegree * kDegree) << step;
    EXPECT_NEAR(perimeter(diagram, 4) / (4 * side), 1, 1e-13 + step * step * kDegree * kDegree) << step;
  }
}

/// Expects that a change of a diagram that is right makes it wrong.
void expectRefused(const SphereDiagram& right, const std::string& name,
                   const std::function<void(SphereDiagram&)>& change) {
  ASSERT_TRUE(checkSphere(right));
  SphereDiagram wrong = right;
  change(wrong);
  EXPECT_FALSE(checkSphere(wrong)) << name;
}

TEST(SphereJudge, RefusesCorruptedDiagrams) {
  std::vector<Cap> caps = {{0, 0, 300}, {0.1, 0, 10}};
  Random random(3);
  for (int k = 0; k < 30; ++k) {
    const Point p = randomPlace(random);
    caps.push_back({p.x, p.y, random.uniform(0, 200)});
  }
  const SphereDiagram right = computed(caps);
  ASSERT_EQ(right.hidden.size(), 1u);
  const auto refuse = [&](const std::string& name, const std::function<void(SphereDiagram&)>& change) {
    expectRefused(right, name, change);
  };
  refuse("a vertex that lies elsewhere", [](SphereDiagram& d) { d.vertices[3].longitude += 1e-9; });
  refuse("a wrong distance", [](SphereDiagram& d) { d.vertices[3].distance += 1e-6; });
  refuse("a cap that lies elsewhere", [](SphereDiagram& d) { d.caps[5].latitude += 1e-9; });
  refuse("a cap of another size", [](SphereDiagram& d) { d.caps[5].r += 1e-6; });
  refuse("a larger hidden cap", [](SphereDiagram& d) { d.caps[1].r += 300; });
  refuse("another hider", [](SphereDiagram& d) { d.hidden[0].by = 7; });
  refuse("nothing hidden", [](SphereDiagram& d) { d.hidden.clear(); });
  refuse("one more hidden", [](SphereDiagram& d) { d.hidden.push_back({9, 3}); });
  refuse("a hidden cap twice", [](SphereDiagram& d) { d.hidden.push_back(d.hidden[0]); });
  refuse("caps in another order", [](SphereDiagram& d) { std::swap(d.vertexCaps[2][0], d.vertexCaps[2][1]); });
  refuse("another cap at a vertex", [](SphereDiagram& d) { d.vertexCaps[2][0] = (d.vertexCaps[2][0] + 1) % 31; });
  refuse("an edge that is turned", [](SphereDiagram& d) { std::swap(d.edges[4].start, d.edges[4].end); });
  refuse("an edge of another cell", [](SphereDiagram& d) {
    d.edges[4].left = d.edges[5].left == d.edges[4].left ? d.edges[5].right : d.edges[5].left;
  });
  refuse("a missing edge", [](SphereDiagram& d) { d.edges.pop_back(); });
  refuse("a missing vertex", [](SphereDiagram& d) { d.vertices.pop_back(); });
  refuse("another next side", [](SphereDiagram& d) { std::swap(d.links.nextSide[0], d.links.nextSide[1]); });
  refuse("another first side",
         [](SphereDiagram& d) { d.links.firstSide[0] = d.links.nextSide[at(d.links.firstSide[0])]; });
  refuse("another side at a vertex",
         [](SphereDiagram& d) { std::swap(d.links.vertexSides[0][0], d.links.vertexSides[0][1]); });
  refuse("an index that does not exist", [](SphereDiagram& d) { d.vertexCaps[0][0] = 1000; });
  refuse("a vertex that does not exist", [](SphereDiagram& d) { d.edges[0].start = 100000; });
  refuse("a number that is none", [](SphereDiagram& d) { d.vertices[0].latitude = std::nan(""); });
  refuse("an unlimited rounding", [](SphereDiagram& d) { d.rounding = std::numeric_limits<double>::infinity(); });
}

/// Replaces an edge of a diagram by the other diagonal of its four caps, with the discs that touch the new triples.
SphereDiagram flipped(const SphereDiagram& diagram, EdgeIndex edge) {
  SphereDiagram result = diagram;
  const Edge old = diagram.edges[at(edge)];
  const auto thirdOf = [&](VertexIndex v) {
    for (const CircleIndex cap : diagram.vertexCaps[at(v)]) {
      if (cap != old.left && cap != old.right) return cap;
    }
    return CircleIndex(kNone);
  };
  const CircleIndex before = thirdOf(old.start);
  const CircleIndex after = thirdOf(old.end);
  const std::array<std::array<CircleIndex, 3>, 2> triples = {{{old.left, before, after}, {old.right, after, before}}};
  const std::array<VertexIndex, 2> vertices = {old.start, old.end};
  for (std::size_t k = 0; k < 2; ++k) {
    const SphereDiagram three =
        computed({diagram.caps[at(triples[k][0])], diagram.caps[at(triples[k][1])], diagram.caps[at(triples[k][2])]});
    for (std::size_t v = 0; v < three.vertices.size(); ++v) {
      auto caps = three.vertexCaps[v];
      while (caps[0] != 0) caps = {caps[1], caps[2], caps[0]};
      if (caps[1] == 1) result.vertices[at(vertices[k])] = three.vertices[v];
    }
    result.vertexCaps[at(vertices[k])] = triples[k];
  }
  // The two edges that change their vertex.
  for (std::size_t e = 0; e < result.edges.size(); ++e) {
    Edge& other = result.edges[e];
    if (static_cast<std::int32_t>(e) == edge) continue;
    const auto joins = [&](CircleIndex a, CircleIndex b) {
      return (other.left == a && other.right == b) || (other.left == b && other.right == a);
    };
    const auto move = [&](VertexIndex from, VertexIndex to) {
      if (other.start == from)
        other.start = to;
      else if (other.end == from)
        other.end = to;
    };
    if (joins(old.left, after))
      move(old.end, old.start);
    else if (joins(old.right, before))
      move(old.start, old.end);
  }
  result.edges[at(edge)] = {after, before, old.start, old.end};
  // Links follow from the rest.
  const auto sideCount = static_cast<std::int32_t>(2 * result.edges.size());
  const auto position = [&](VertexIndex v, CircleIndex cap) {
    return static_cast<std::size_t>(std::ranges::find(result.vertexCaps[at(v)], cap) -
                                    result.vertexCaps[at(v)].begin());
  };
  for (SideIndex side = sideCount - 1; side >= 0; side = side - 1) {
    const VertexIndex start = result.originOf(side);
    const std::size_t k = position(start, result.circleOf(side));
    if (k < 3) result.links.vertexSides[at(start)][k] = side;
    result.links.firstSide[at(result.circleOf(side))] = side;
  }
  for (SideIndex side = 0; side < sideCount; ++side) {
    const std::size_t k = position(result.targetOf(side), result.circleOf(side));
    if (k < 3) result.links.nextSide[at(side)] = result.links.vertexSides[at(result.targetOf(side))][k];
  }
  return result;
}

TEST(SphereJudge, RefusesFlippedEdges) {
  std::vector<Cap> caps;
  Random random(31);
  for (int k = 0; k < 40; ++k) {
    const Point p = randomPlace(random);
    caps.push_back({p.x, p.y, random.uniform(0, 300)});
  }
  const SphereDiagram right = computed(caps);
  int consistent = 0;
  for (EdgeIndex e = 0; e < static_cast<std::int32_t>(right.edges.size()); ++e) {
    const auto checked = checkSphere(flipped(right, e));
    ASSERT_FALSE(checked) << e;
    // Only discs and order are wrong.
    consistent += checked.error().code == ErrorCode::notCertified ? 1 : 0;
  }
  EXPECT_EQ(consistent, static_cast<int>(right.edges.size()));
}

TEST(Elementary, FunctionsAreRightToAFewUnits) {
  Random random(1);
  for (int k = 0; k < 20000; ++k) {
    const double x = random.uniform(-7, 7) * (k % 2 == 0 ? 1 : random.unit() * 1e-3);
    EXPECT_NEAR(sineCosine(x).sine, std::sin(x), 3e-16 * std::max(1e-3, std::abs(std::sin(x))) + 1e-19);
    EXPECT_NEAR(sineCosine(x).cosine, std::cos(x), 3e-16);
    const double degrees = random.uniform(-400, 400);
    const long double radians = static_cast<long double>(degrees) * 3.14159265358979323846264L / 180;
    EXPECT_NEAR(sineCosineOfDegrees(degrees).sine, static_cast<double>(std::sin(radians)), 3e-16);
    const double a = random.uniform(-1, 1);
    const double b = random.uniform(-1, 1);
    EXPECT_NEAR(angleOf(a, b), std::atan2(a, b), 5e-16 * std::abs(std::atan2(a, b)));
    EXPECT_NEAR(angleOf(1e-9 * a, b), std::atan2(1e-9 * a, b), 5e-16 * std::abs(std::atan2(1e-9 * a, b)));
  }
  for (const double degrees : {-270.0, -180.0, -90.0, 0.0, 90.0, 180.0, 270.0, 360.0}) {
    const auto [sine, cosine] = sineCosineOfDegrees(degrees);
    EXPECT_EQ(sine * cosine, 0);
    EXPECT_EQ(std::abs(sine) + std::abs(cosine), 1);
  }
}

}  // namespace
}  // namespace circle_voronoi
