// SPDX-License-Identifier: GPL-3.0-or-later
#include "clip_families.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "at.h"

namespace circle_voronoi::test {
namespace {

using Random = std::mt19937_64;

int pick(Random& random, int least, int most) { return std::uniform_int_distribution<int>(least, most)(random); }
double unit(Random& random) { return std::uniform_real_distribution<double>(0, 1)(random); }
bool toss(Random& random) { return pick(random, 0, 1) == 1; }

Metric anyMetric(Random& random) {
  constexpr std::array kMetrics = {Metric::circles, Metric::circles, Metric::circles, Metric::centers, Metric::power};
  return kMetrics[static_cast<std::size_t>(pick(random, 0, 4))];
}

/// A point with integer coordinates whose distance from the origin is an integer, too.
struct Pythagorean {
  double x, y, length;
};
Pythagorean pythagorean(Random& random, int mostFactor) {
  constexpr std::array<std::array<int, 3>, 9> kTriples = {{{1, 0, 1},
                                                           {3, 4, 5},
                                                           {5, 12, 13},
                                                           {8, 15, 17},
                                                           {7, 24, 25},
                                                           {20, 21, 29},
                                                           {12, 35, 37},
                                                           {9, 40, 41},
                                                           {28, 45, 53}}};
  auto [x, y, length] = kTriples[static_cast<std::size_t>(pick(random, 0, 8))];
  if (toss(random)) std::swap(x, y);
  const int factor = pick(random, 1, std::max(1, mostFactor / length));
  return {static_cast<double>((toss(random) ? 1 : -1) * factor * x),
          static_cast<double>((toss(random) ? 1 : -1) * factor * y), static_cast<double>(factor * length)};
}

/// Circles that touch one disc around the origin, and perhaps others that stay clear of it.
std::vector<Circle> touching(Random& random, int count, int others) {
  std::vector<Pythagorean> places;
  double least = 1e9;
  for (int i = 0; i < count; ++i) {
    places.push_back(pythagorean(random, 150));
    least = std::min(least, places.back().length);
  }
  const double radius = toss(random) ? least : std::floor(unit(random) * least * 2) / 2;
  std::vector<Circle> circles;
  for (const auto& [x, y, length] : places) circles.push_back({x, y, length - radius});
  for (int i = 0; i < others; ++i) {
    const Pythagorean place = pythagorean(random, 300);
    circles.push_back({place.x, place.y, std::floor(unit(random) * std::max(place.length - radius, 0.0))});
  }
  std::ranges::shuffle(circles, random);
  return circles;
}

/// Corners with integer coordinates around the origin, by angle.
Region::Ring around(Random& random, int corners, int size) {
  Region::Ring ring;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * (k + 0.7 * unit(random)) / corners;
    const double r = size * (0.2 + 0.8 * unit(random));
    ring.push_back({std::round(r * std::cos(angle)), std::round(r * std::sin(angle))});
  }
  return ring;
}

/// A ring with a corner at the origin.
Region::Ring cornerAtOrigin(Random& random, int size) {
  Region::Ring ring = around(random, pick(random, 4, 8), size);
  const auto first = pick(random, 0, static_cast<int>(ring.size()) - 1);
  std::ranges::rotate(ring, ring.begin() + first);
  ring.resize(static_cast<std::size_t>(pick(random, 2, static_cast<int>(ring.size()) - 1)));
  ring.insert(ring.begin() + pick(random, 0, static_cast<int>(ring.size())), {0, 0});
  return ring;
}

ClipInput cornerAtVertex(Random& random) {
  return {touching(random, pick(random, 3, 12), 0), {cornerAtOrigin(random, 200)}, anyMetric(random)};
}

ClipInput cornerOnEdge(Random& random) {
  return {touching(random, 2, pick(random, 0, 5)), {cornerAtOrigin(random, 200)}, anyMetric(random)};
}

ClipInput sideThroughVertex(Random& random) {
  const Point p = {static_cast<double>(pick(random, -50, 50)), static_cast<double>(pick(random, -50, 50))};
  const double far = pick(random, 1, 3);
  Region::Ring ring = {{-p.x, -p.y}, {far * p.x, far * p.y}};
  for (int k = 0; k < pick(random, 1, 2); ++k) {
    const double along = pick(random, -1, 3);
    const double across = pick(random, 1, 4);
    ring.push_back({along * p.x - across * p.y, along * p.y + across * p.x});
  }
  return {touching(random, pick(random, 2, 8), pick(random, 0, 3)), {ring}, anyMetric(random)};
}

/// Circles and their mirror images: an edge along the mirror, which is the y axis.
ClipInput sideAlongEdge(Random& random) {
  ClipInput input;
  input.metric = anyMetric(random);
  for (int i = 0, count = pick(random, 1, 3); i < count; ++i) {
    const Circle c = {static_cast<double>(pick(random, 1, 40)), static_cast<double>(pick(random, -40, 40)),
                      static_cast<double>(pick(random, 0, 12))};
    input.circles.push_back(c);
    input.circles.push_back({-c.x, c.y, c.r});
  }
  const double low = pick(random, -60, 0);
  const double high = pick(random, 1, 60);
  const double side = toss(random) ? 1 : -1;
  switch (pick(random, 0, 2)) {
    case 0:
      input.rings = {{{0, low}, {0, high}, {side * pick(random, 1, 60), std::floor((low + high) / 2)}}};
      break;
    case 1: {
      const double middle = std::floor(low + unit(random) * (high - low));
      input.rings = {{{side * 50, low - 1},
                      {side * 50, high + 1},
                      {-side * 30, high + 1},
                      {-side * 30, high},
                      {0, high},
                      {0, middle},
                      {-side * 10, middle},
                      {-side * 10, low},
                      {0, low},
                      {0, low - 1}}};
      break;
    }
    default:
      // A comb along the edge.
      Region::Ring ring = {{side * 50, low - 1}, {side * 50, high + 1}};
      for (double y = high; y >= low; y -= 4) {
        ring.push_back({0, y});
        ring.push_back({0, y - 1});
        ring.push_back({side * pick(random, -9, 9), y - 2});
      }
      input.rings = {ring};
  }
  // The whole turned by 90 degrees, and moved.
  const bool isTurned = toss(random);
  const double x = pick(random, -9, 9);
  const double y = pick(random, -9, 9);
  const auto moved = [&](double px, double py) { return isTurned ? Point{x - py, y + px} : Point{x + px, y + py}; };
  for (Circle& c : input.circles) {
    const Point p = moved(c.x, c.y);
    c = {p.x, p.y, c.r};
  }
  for (auto& ring : input.rings) {
    for (Point& p : ring) p = moved(p.x, p.y);
  }
  return input;
}

ClipInput tangentSide(Random& random) {
  // The line of centers is an axis or has the direction (3, 4); the apex is a point with integer coordinates.
  const bool isSlanted = toss(random);
  const Point axis = isSlanted ? Point{3, 4} : Point{5, 0};
  const double large = pick(random, 1, 20);
  const double small = pick(random, 0, 20);
  const double gap = 2 * pick(random, 1, 10);
  ClipInput input;
  // In units of 5: one circle before the apex, one beyond it, as far from it as each other.
  const double before = large + gap / 2;
  const double beyond = small + gap / 2;
  input.circles = {{-before * axis.x, -before * axis.y, 5 * large}, {beyond * axis.x, beyond * axis.y, 5 * small}};
  for (int i = 0, count = pick(random, 0, 3); i < count; ++i) {
    input.circles.push_back({static_cast<double>(pick(random, -300, 300)), static_cast<double>(pick(random, -300, 300)),
                             static_cast<double>(pick(random, 0, 40))});
  }
  const Point along = {-axis.y, axis.x};
  const double low = -pick(random, 1, 60);
  const double high = pick(random, 1, 60);
  const double way = (toss(random) ? 1 : -1) * pick(random, 1, 30);
  input.rings = {{{low * along.x, low * along.y},
                  {high * along.x, high * along.y},
                  {way * axis.x + high * along.x, way * axis.y + high * along.y},
                  {way * axis.x + low * along.x, way * axis.y + low * along.y}}};
  if (toss(random)) input.rings[0].insert(input.rings[0].begin() + 1, {0, 0});
  return input;
}

ClipInput touchingHoles(Random& random) {
  ClipInput input;
  input.circles = touching(random, pick(random, 2, 6), pick(random, 0, 3));
  input.metric = anyMetric(random);
  // Rings that touch each other at the origin only, in different wedges of directions; the outer ring may touch it,
  // too.
  const bool touchesOuter = toss(random);
  constexpr std::array<std::array<double, 4>, 6> kWedges = {
      {{3, 1, 2, 2}, {-1, 3, 1, 4}, {-3, 2, -4, 1}, {-3, -1, -2, -2}, {0, -3, -1, -4}, {3, -2, 4, -1}}};
  const double outer = 200;
  if (touchesOuter) {
    input.rings.push_back({{0, 0}, {outer, -10}, {outer, outer}, {-outer, outer}, {-outer, -10}});
  } else {
    input.rings.push_back({{outer, -outer}, {outer, outer}, {-outer, outer}, {-outer, -outer}});
  }
  for (std::size_t k = 0; k < kWedges.size(); ++k) {
    if (toss(random) || (touchesOuter && k >= 3)) continue;
    const auto& [ax, ay, bx, by] = kWedges[k];
    const double f = pick(random, 1, 20);
    const double g = pick(random, 1, 20);
    input.rings.push_back({{0, 0}, {f * ax, f * ay}, {g * bx, g * by}});
  }
  return input;
}

/// Holes that touch each other at points of one edge, which is straight or a hyperbola, in a chain along it.
ClipInput holesAlongEdge(Random& random) {
  ClipInput input;
  const double small = pick(random, 0, 30);
  std::vector<Point> places;
  if (toss(random)) {
    // The hyperbola with the axes 32 and 24.
    input.circles = {{-40, 0, 64 + small}, {40, 0, small}};
    places = {{68, -45}, {40, -18}, {32, 0}, {40, 18}, {68, 45}};
  } else {
    input.metric = anyMetric(random);
    input.circles = {{-40, 0, small}, {40, 0, small}};
    places = {{0, -45}, {0, -16}, {0, 0}, {0, 20}, {0, 50}};
  }
  input.rings = {{{-200, -200}, {200, -200}, {200, 200}, {-200, 200}}};
  const int first = pick(random, 0, 2);
  const int last = pick(random, first + 1, 4);
  for (int k = first; k < last; ++k) {
    const Point p = places[static_cast<std::size_t>(k)];
    const Point q = places[static_cast<std::size_t>(k) + 1];
    // Corners on both sides of the chord, or on one, at a height at which no other hole is.
    const double low = pick(random, 1, 14);
    const double high = pick(random, 1, 14);
    const Point onRight = {std::max(p.x, q.x) + pick(random, 1, 40), p.y + low};
    const Point onLeft = {std::min(p.x, q.x) - pick(random, 1, 40), p.y + high};
    const int kind = pick(random, 0, 2);
    if (kind == 0) input.rings.push_back({p, onRight, q, onLeft});
    if (kind == 1) input.rings.push_back({p, onRight, q});
    if (kind == 2) input.rings.push_back({p, q, onLeft});
  }
  if (toss(random)) {
    std::swap(input.circles[0], input.circles[1]);
    std::ranges::reverse(input.rings.begin() + 1, input.rings.end());
  }
  // The whole turned by quarters.
  for (int turns = pick(random, 0, 3); turns > 0; --turns) {
    for (Circle& c : input.circles) c = {-c.y, c.x, c.r};
    for (auto& ring : input.rings) {
      for (Point& p : ring) p = {-p.y, p.x};
    }
  }
  return input;
}

ClipInput insideOneCell(Random& random) {
  ClipInput input = cornerOnEdge(random);
  input.circles.push_back({0, 0, 1});
  const double size = std::ldexp(1.0, -pick(random, 1, 40));
  for (auto& ring : input.rings) {
    for (Point& p : ring) p = {p.x * size, p.y * size};
  }
  return input;
}

ClipInput farAndTiny(Random& random) {
  ClipInput input;
  switch (pick(random, 0, 2)) {
    case 0:
      input = cornerAtVertex(random);
      break;
    case 1:
      input = sideThroughVertex(random);
      break;
    default:
      input = tangentSide(random);
  }
  // The origin stays a vertex at any scale of the region.
  const double scale = std::pow(10.0, pick(random, -15, 15));
  for (auto& ring : input.rings) {
    for (Point& p : ring) p = {p.x * scale, p.y * scale};
  }
  return input;
}

ClipInput grid(Random& random) {
  ClipInput input;
  input.metric = anyMetric(random);
  const int columns = pick(random, 1, 5);
  const int rows = pick(random, 1, 4);
  const bool isStaggered = toss(random);
  const double step = 2;
  const bool hasTwoSizes = toss(random);
  const double r = toss(random) ? 0.5 : unit(random);
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      if (pick(random, 0, 9) == 0) continue;
      const double shift = isStaggered && j % 2 == 1 ? step / 2 : 0;
      input.circles.push_back({step * i + shift, step * j, hasTwoSizes && (i + j) % 2 == 0 ? r / 2 : r});
    }
  }
  if (input.circles.empty()) input.circles.push_back({0, 0, r});
  std::ranges::shuffle(input.circles, random);
  const auto corner = [&] {
    return Point{static_cast<double>(pick(random, -2, 2 * columns + 2)),
                 static_cast<double>(pick(random, -2, 2 * rows + 2))};
  };
  if (toss(random)) {
    const Point a = corner();
    const Point b = corner();
    input.rings = {{a, {b.x, a.y}, b, {a.x, b.y}}};
  } else {
    Region::Ring ring;
    for (int k = 0, count = pick(random, 3, 5); k < count; ++k) ring.push_back(corner());
    input.rings = {ring};
  }
  return input;
}

ClipInput anything(Random& random) {
  ClipInput input;
  input.metric = anyMetric(random);
  for (int i = 0, count = pick(random, 1, 10); i < count; ++i) {
    input.circles.push_back({unit(random), unit(random), 0.3 * unit(random) * unit(random)});
  }
  Region::Ring ring = around(random, pick(random, 3, 12), 1000);
  for (Point& p : ring) p = {0.5 + p.x * 0.0007, 0.5 + p.y * 0.0007};
  input.rings = {ring};
  return input;
}

}  // namespace

double extentOf(const Region& region) {
  const Box box = region.bounds();
  return std::max(box.maxX - box.minX, box.maxY - box.minY);
}

double farthestOf(const ClipInput& input) {
  double farthest = 0;
  for (const Circle& c : input.circles) farthest = std::max({farthest, std::abs(c.x), std::abs(c.y), c.r});
  for (const auto& ring : input.rings) {
    for (const Point& p : ring) farthest = std::max({farthest, std::abs(p.x), std::abs(p.y)});
  }
  return farthest;
}

double radiusOf(const ClipInput& input, const Circle& circle) { return input.metric == Metric::circles ? circle.r : 0; }

double distanceOfReach(const ClipInput& input, const Circle& circle, double reach) {
  if (input.metric != Metric::power) return reach - radiusOf(input, circle);
  const double power = (reach - circle.r) * (reach + circle.r);
  return std::copysign(std::sqrt(std::abs(power)), power);
}

double anyDistance(const ClipInput& input, std::mt19937_64& random) {
  const auto& circles = input.circles;
  const Circle& c = circles[static_cast<std::size_t>(pick(random, 0, static_cast<int>(circles.size()) - 1))];
  const Circle& d = circles[static_cast<std::size_t>(pick(random, 0, static_cast<int>(circles.size()) - 1))];
  const double r = radiusOf(input, c);
  const auto& ring = input.rings.back();
  const auto corner = static_cast<std::size_t>(pick(random, 0, static_cast<int>(ring.size()) - 1));
  const Point p = ring[corner];
  const double toCorner = std::hypot(p.x - c.x, p.y - c.y);
  switch (pick(random, 0, 5)) {
    case 0:
      return distanceOfReach(input, c, toCorner);
    case 1:
      // The circles of many families touch one disc around the origin.
      return distanceOfReach(input, c, std::hypot(c.x, c.y));
    case 2: {
      const double apart = std::hypot(d.x - c.x, d.y - c.y);
      if (input.metric != Metric::power) return (apart - r - radiusOf(input, d)) / 2;
      return apart > 0 ? distanceOfReach(input, c, std::abs(apart + (c.r - d.r) / apart * (c.r + d.r)) / 2) : 0;
    }
    case 3:
      return toss(random) ? 0 : -std::floor(r / 2);
    case 4: {
      const Point q = ring[(corner + 1) % ring.size()];
      const double size = std::hypot(p.x - q.x, p.y - q.y);
      const double height = (p.x - q.x) * (c.y - q.y) - (p.y - q.y) * (c.x - q.x);
      return size > 0 ? distanceOfReach(input, c, std::abs(height) / size) : 1;
    }
    default:
      return distanceOfReach(input, c, (0.2 + 1.2 * unit(random)) * toCorner);
  }
}

std::vector<std::vector<Region::Ring>> polygonsOf(const ClippedPolygons& all, std::size_t cell) {
  std::vector<std::vector<Region::Ring>> polygons;
  for (std::int32_t p = all.polygonOffsets[cell]; p < all.polygonOffsets[cell + 1]; ++p) {
    auto& rings = polygons.emplace_back();
    for (std::int32_t r = all.ringOffsets[at(p)]; r < all.ringOffsets[at(p) + 1]; ++r) {
      rings.emplace_back(all.points.begin() + all.pointOffsets[at(r)],
                         all.points.begin() + all.pointOffsets[at(r) + 1]);
    }
  }
  return polygons;
}

bool hasPolygons(const ClipInput& input) {
  constexpr double kMost = 1e6;
  double reach = 0;
  for (const Circle& c : input.circles) reach = std::max({reach, std::abs(c.x), std::abs(c.y), std::abs(c.r)});
  for (const auto& ring : input.rings) {
    for (const Point& p : ring) {
      if (std::max(std::abs(p.x), std::abs(p.y)) > kMost * reach) return false;
    }
  }
  return true;
}

const std::vector<ClipFamily>& clipFamilies() {
  static const std::vector<ClipFamily> families = {{"corner at a vertex", cornerAtVertex},
                                                   {"corner on an edge", cornerOnEdge},
                                                   {"side through a vertex", sideThroughVertex},
                                                   {"side along an edge", sideAlongEdge},
                                                   {"side tangent to an arc", tangentSide},
                                                   {"touching holes", touchingHoles},
                                                   {"inside one cell", insideOneCell},
                                                   {"far away and tiny", farAndTiny},
                                                   {"grid", grid},
                                                   {"anything", anything},
                                                   {"holes along an edge", holesAlongEdge}};
  return families;
}

}  // namespace circle_voronoi::test
