// SPDX-License-Identifier: GPL-3.0-or-later
#include "regions.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <random>

#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/region.h"
#include "circle_voronoi_families/families.h"
#include "median.h"
#include "processor_seconds.h"

namespace circle_voronoi::bench {
namespace {

/// A closed line around a point, rough at every scale: distances are sums of waves of halving length.
Region::Ring coastline(Point center, double radius, std::size_t sides, unsigned seed) {
  std::mt19937_64 random(seed);
  const auto draw = [&] { return static_cast<double>(random() >> 11) * 0x1p-52 - 1; };
  std::vector<double> height(sides, 0);
  double size = 0.25;
  for (std::size_t knots = 4; knots < sides; knots *= 2, size *= 0.6) {
    std::vector<double> at(knots);
    for (double& value : at) value = size * draw();
    for (std::size_t k = 0; k < sides; ++k) {
      const double place = static_cast<double>(k) / static_cast<double>(sides) * static_cast<double>(knots);
      const auto left = static_cast<std::size_t>(place);
      const double share = place - static_cast<double>(left);
      height[k] += at[left % knots] * (1 - share) + at[(left + 1) % knots] * share;
    }
  }
  Region::Ring ring;
  for (std::size_t k = 0; k < sides; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(sides);
    const double r = radius * std::exp(height[k]);
    ring.push_back({center.x + r * std::cos(angle), center.y + r * std::sin(angle)});
  }
  return ring;
}

void benchRegion(const std::string& family, const std::vector<Circle>& circles, std::size_t sides, int repetitions) {
  double minX = circles[0].x, maxX = minX, minY = circles[0].y, maxY = minY;
  for (const Circle& c : circles) {
    minX = std::min(minX, c.x);
    maxX = std::max(maxX, c.x);
    minY = std::min(minY, c.y);
    maxY = std::max(maxY, c.y);
  }
  const Point center = {(minX + maxX) / 2, (minY + maxY) / 2};
  const Region::Ring ring = coastline(center, 0.35 * std::max(maxX - minX, maxY - minY), sides, 1);
  const std::vector<Region::Ring> rings = {ring};
  const Diagram diagram = compute(circles).value();
  const Region region = Region::fromRings(rings).value();
  const ClippedDiagram clipped = ClippedDiagram::from(diagram, region).value();
  const double error = [&] {
    double sum = 0;
    for (const double area : clipped.areas()) sum += area;
    return std::abs(sum / region.area() - 1);
  }();
  if (!(error < 1e-12)) std::abort();
  struct Step {
    const char* name;
    std::function<void()> run;
    std::vector<double> seconds = {};
  };
  std::vector<Step> tasks = {{"compute", [&] { (void)compute(circles); }},
                             {"region", [&] { (void)Region::fromRings(rings); }},
                             {"clip and areas", [&] { (void)ClippedDiagram::from(diagram, region)->areas(); }},
                             {"outlines", [&] { (void)clipped.cells(); }},
                             {"polygons", [&] { (void)clipped.polygons(1e-3 * (maxX - minX)); }}};
  for (int i = 0; i < repetitions; ++i) {
    for (Step& task : tasks) task.seconds.push_back(processorSeconds(task.run));
  }
  for (const Step& task : tasks) {
    std::vector<double> ratios;
    for (int k = 0; k < repetitions; ++k) ratios.push_back(task.seconds[k] / tasks[0].seconds[k]);
    std::printf("%-14s %8zu %8zu  %-14s %10.4f %10.2f\n", family.c_str(), circles.size(), sides, task.name,
                median(task.seconds), median(ratios));
  }
  std::fflush(stdout);
}

/// Polygons of a region with points along the edge between two circles. The time per point should not depend on the
/// number of points.
void benchAlongEdge(std::size_t points, int repetitions) {
  const std::vector<Circle> circles = {{-1, 0, 0}, {1, 0, 0}};
  Region::Ring ring = {{0, -1}, {3, -1}, {3, 1}};
  for (std::size_t k = 0; k < points; ++k) {
    ring.push_back({0, 1 - 2 * static_cast<double>(k) / static_cast<double>(points)});
  }
  const Diagram diagram = compute(circles).value();
  const Region region = Region::fromRings({{ring}}).value();
  std::vector<double> seconds;
  for (int i = 0; i < repetitions; ++i) {
    seconds.push_back(processorSeconds([&] { (void)ClippedDiagram::from(diagram, region)->polygons(1e-3); }));
  }
  const double time = median(seconds);
  std::printf("%-24s %8zu %10.4f %10.2f\n", "points along an edge", points, time,
              1e6 * time / static_cast<double>(points));
}

}  // namespace

void benchRegions(const std::vector<std::string>& families, const std::vector<std::size_t>& sizes,
                  const std::vector<std::size_t>& sides, int repetitions) {
  std::printf("%-14s %8s %8s  %-14s %10s %10s\n", "family", "n", "sides", "task", "median s", "/ compute");
  for (const std::string& name : families) {
    const Family family = familyFromName(name).value();
    for (const std::size_t size : sizes) {
      const std::vector<Circle> circles = generate(family, size, 1);
      for (const std::size_t count : sides) benchRegion(name, circles, count, repetitions);
    }
  }
  std::printf("\n%-24s %8s %10s %10s\n", "polygons", "points", "median s", "us a point");
  for (const std::size_t points : {6585, 13170, 26340}) benchAlongEdge(points, repetitions);
}

}  // namespace circle_voronoi::bench
