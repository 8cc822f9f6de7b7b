// SPDX-License-Identifier: GPL-3.0-or-later
#include "region_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "circle_voronoi/cells.h"
#include "circle_voronoi/curve.h"

namespace circle_voronoi::test {
namespace {

Region::Ring boxRing(const Box& box) {
  return {{box.minX, box.minY}, {box.maxX, box.minY}, {box.maxX, box.maxY}, {box.minX, box.maxY}};
}

Point mixed(Point p, Point q, double share) { return {p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)}; }

/// The box of the circles' centers, a little larger.
Box boxOf(const Diagram& diagram) {
  Box box = {1e300, 1e300, -1e300, -1e300};
  for (const Circle& c : diagram.circles) {
    box = {std::min(box.minX, c.x), std::min(box.minY, c.y), std::max(box.maxX, c.x), std::max(box.maxY, c.y)};
  }
  const double size = std::max({box.maxX - box.minX, box.maxY - box.minY, 1e-3});
  return {box.minX - size / 7, box.minY - size / 9, box.maxX + size / 8, box.maxY + size / 5};
}

}  // namespace

Region::Ring starRing(std::mt19937_64& random, Point center, double least, double most, std::size_t corners) {
  std::uniform_real_distribution<double> distance(least, most);
  Region::Ring ring;
  for (std::size_t k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(corners);
    const double r = distance(random);
    ring.push_back({center.x + r * std::cos(angle), center.y + r * std::sin(angle)});
  }
  return ring;
}

Region::Ring coastRing(std::mt19937_64& random, Point center, double radius, std::size_t corners) {
  // Distances as a sum of waves of halving length: star-shaped, so that no sides cross, and rough at every scale.
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<double> height(corners, 0);
  double size = 0.35;
  for (std::size_t knots = 4; knots < 2 * corners; knots *= 2, size *= 0.6) {
    std::vector<double> at(knots);
    for (double& value : at) value = size * unit(random);
    for (std::size_t k = 0; k < corners; ++k) {
      const double place = static_cast<double>(k) / static_cast<double>(corners) * static_cast<double>(knots);
      const auto left = static_cast<std::size_t>(place);
      const double share = place - static_cast<double>(left);
      height[k] += at[left % knots] * (1 - share) + at[(left + 1) % knots] * share;
    }
  }
  Region::Ring ring;
  for (std::size_t k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(corners);
    const double r = radius * std::exp(height[k] - 0.3);
    ring.push_back({center.x + r * std::cos(angle), center.y + r * std::sin(angle)});
  }
  return ring;
}

Region::Ring combRing(const Box& box, std::size_t teeth) {
  const double step = (box.maxX - box.minX) / static_cast<double>(2 * teeth - 1);
  const double low = box.minY + (box.maxY - box.minY) / 20;
  Region::Ring ring = {{box.minX, box.minY}, {box.maxX, box.minY}};
  for (std::size_t k = 0; k < teeth; ++k) {
    const double right = box.maxX - 2 * static_cast<double>(k) * step;
    const double left = k + 1 == teeth ? box.minX : right - step;
    ring.push_back({right, box.maxY});
    ring.push_back({left, box.maxY});
    if (k + 1 < teeth) {
      ring.push_back({left, low});
      ring.push_back({box.maxX - 2 * static_cast<double>(k + 1) * step, low});
    }
  }
  return ring;
}

Region::Ring spiralRing(const Box& box, std::size_t turns) {
  const Point center = {(box.minX + box.maxX) / 2, (box.minY + box.maxY) / 2};
  const double size = std::min(box.maxX - box.minX, box.maxY - box.minY) / 2;
  const std::size_t steps = 24 * turns;
  Region::Ring outer;
  Region::Ring inner;
  for (std::size_t k = 0; k <= steps; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / 24;
    const double pitch = size / static_cast<double>(turns + 1);
    const double r = pitch * (0.3 + static_cast<double>(k) / 24);
    outer.push_back({center.x + (r + 0.4 * pitch) * std::cos(angle), center.y + (r + 0.4 * pitch) * std::sin(angle)});
    inner.push_back({center.x + r * std::cos(angle), center.y + r * std::sin(angle)});
  }
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  return outer;
}

std::vector<RegionShape> hardRegions(const Diagram& diagram, std::mt19937_64& random) {
  std::vector<RegionShape> shapes;
  const auto add = [&](const char* name, const std::vector<Region::Ring>& rings) {
    const auto region = Region::fromRings(rings);
    if (region) shapes.push_back({name, *region});
  };
  const Box box = boxOf(diagram);
  const double width = box.maxX - box.minX;
  const double height = box.maxY - box.minY;
  const Point center = {(box.minX + box.maxX) / 2, (box.minY + box.maxY) / 2};
  const double size = std::max(width, height);

  add("box", {boxRing(box)});
  add("star", {starRing(random, center, 0.05 * size, 0.6 * size, 40)});
  add("coast", {coastRing(random, center, 0.5 * size, 500)});
  add("comb", {combRing(box, 15)});
  add("spiral", {spiralRing(box, 5)});
  add("far away", {boxRing({box.maxX + 20 * size, box.minY, box.maxX + 21 * size, box.maxY})});
  add("large", {boxRing({box.minX - 30 * size, box.minY - 40 * size, box.maxX + 50 * size, box.maxY + 20 * size})});
  add("lake with islands", {boxRing(box), starRing(random, center, 0.2 * size, 0.3 * size, 30),
                            starRing(random, center, 0.02 * size, 0.15 * size, 20)});

  std::vector<Region::Ring> pillars = {boxRing(box)};
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      const Point p = {box.minX + width * (i + 0.5) / 6, box.minY + height * (j + 0.5) / 6};
      pillars.push_back(starRing(random, p, 0.005 * size, 0.07 * size, 7));
    }
  }
  add("pillars", pillars);

  // Corners on vertices, along edges, and across them.
  const auto& vertices = diagram.vertices;
  const auto isNear = [&](Point p) { return box.minX < p.x && p.x < box.maxX && box.minY < p.y && p.y < box.maxY; };
  std::vector<Point> places;
  for (const Vertex& v : vertices) {
    if (isNear({v.x, v.y})) places.push_back({v.x, v.y});
  }
  std::ranges::shuffle(places, random);
  places.resize(std::min<std::size_t>(places.size(), 30));
  const auto byAngle = [&](std::vector<Point> points) {
    std::ranges::sort(points, {}, [&](Point p) { return std::atan2(p.y - center.y, p.x - center.x); });
    return points;
  };
  if (places.size() >= 3) add("corners on vertices", {byAngle(places)});
  for (std::size_t e = 0, count = 0; e < diagram.edges.size() && count < 3; ++e) {
    const auto& [left, right, start, end] = diagram.edges[e];
    if (start == kNone || end == kNone) continue;
    const EdgeCurve curve = edgeCurve(diagram, static_cast<std::int32_t>(e));
    if (!isNear(curve.start) || !isNear(curve.end) || curve.start == curve.end) continue;
    const double from = curve.from;
    const double to = curve.to;
    const Point middle = pointAt(curve.bisector, std::sqrt(from) * std::sqrt(to));
    const Circle& c = diagram.circles[static_cast<std::size_t>(left)];
    const Circle& d = diagram.circles[static_cast<std::size_t>(right)];
    ++count;
    add("side along an edge", {{curve.start, curve.end, {c.x, c.y}}});
    add("side beyond an edge", {{mixed(curve.start, curve.end, -0.5), mixed(curve.start, curve.end, 1.5), {d.x, d.y}}});
    add("corner on an edge", {{middle, {c.x, c.y}, mixed(curve.start, {c.x, c.y}, -0.3)}});
    // A side that touches the edge in its middle.
    const Vector along = {curve.end.x - curve.start.x, curve.end.y - curve.start.y};
    add("tangent side",
        {{{middle.x - along.x, middle.y - along.y}, {middle.x + along.x, middle.y + along.y}, {c.x, c.y}}});
    add("tangent side from the other circle",
        {{{middle.x - along.x, middle.y - along.y}, {middle.x + along.x, middle.y + along.y}, {d.x, d.y}}});
    // A side that crosses the arc twice.
    add("chord", {{mixed(curve.start, middle, 0.2), mixed(curve.end, middle, 0.2), {d.x, d.y}}});
  }
  // Regions smaller than a cell, and holes in a cell and around it.
  std::uniform_int_distribution<std::size_t> pick(0, diagram.circles.size() - 1);
  for (int k = 0; k < 4; ++k) {
    const std::size_t i = pick(random);
    const Circle& c = diagram.circles[i];
    add("inside a cell", {starRing(random, {c.x, c.y}, 1e-5 * size, 1e-3 * size, 9)});
    add("hole in a cell", {boxRing(box), starRing(random, {c.x, c.y}, 1e-5 * size, 1e-3 * size, 9)});
    add("hole around a cell", {boxRing(box), starRing(random, {c.x, c.y}, 0.06 * size, 0.12 * size, 12)});
  }
  // Thinner than rounding.
  for (int k = 0; k < 3 && !places.empty(); ++k) {
    const Point p = places[static_cast<std::size_t>(k) % places.size()];
    const Point left = {p.x - 0.3 * size, p.y};
    const Point right = {p.x + 0.4 * size, p.y + 0.1 * size};
    const Point above = {left.x, std::nextafter(left.y, 1e300)};
    add("sliver", {{left, right, above}});
    add("needle at a vertex", {{p, {right.x, right.y}, {right.x, std::nextafter(right.y, 1e300)}}});
  }
  return shapes;
}

}  // namespace circle_voronoi::test
