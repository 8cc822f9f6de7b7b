// SPDX-License-Identifier: GPL-3.0-or-later
#include "periodic.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "circle_voronoi/box.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/compute_periodic.h"
#include "circle_voronoi/periodic_diagram.h"
#include "circle_voronoi_families/families.h"
#include "median.h"
#include "processor_seconds.h"

namespace circle_voronoi::bench {
namespace {

/// The square around the centers.
Lattice boxAround(const std::vector<Circle>& circles) {
  Box box = {circles[0].x, circles[0].y, circles[0].x, circles[0].y};
  for (const Circle& c : circles) {
    box = {std::min(box.minX, c.x), std::min(box.minY, c.y), std::max(box.maxX, c.x), std::max(box.maxY, c.y)};
  }
  const double size = std::max(box.maxX - box.minX, box.maxY - box.minY);
  return {{size, 0}, {0, size}};
}

void benchOne(const std::string& family, const std::vector<Circle>& circles, int repetitions) {
  const Lattice lattice = boxAround(circles);
  const std::vector<Circle> images = computePeriodic(circles, lattice).value().diagram.circles;
  std::vector<double> alone;
  std::vector<double> all;
  std::vector<double> periodic;
  std::vector<double> toAlone;
  std::vector<double> toAll;
  for (int i = 0; i < repetitions; ++i) {
    alone.push_back(processorSeconds([&] { (void)compute(circles); }));
    periodic.push_back(processorSeconds([&] { (void)computePeriodic(circles, lattice); }));
    all.push_back(processorSeconds([&] { (void)compute(images); }));
    toAlone.push_back(periodic.back() / alone.back());
    toAll.push_back(periodic.back() / all.back());
  }
  std::printf("%-14s %8zu %8.3f %10.4f %10.4f %10.4f %8.2f %8.2f\n", family.c_str(), circles.size(),
              static_cast<double>(images.size()) / static_cast<double>(circles.size()), median(alone), median(all),
              median(periodic), median(toAlone), median(toAll));
}

}  // namespace

void benchPeriodic(const std::vector<std::string>& families, const std::vector<std::size_t>& sizes, int repetitions) {
  std::printf("%-14s %8s %8s %10s %10s %10s %8s %8s\n", "family", "n", "images/n", "compute", "of images", "periodic",
              "ratio", "to images");
  for (const std::string& family : families) {
    for (const std::size_t size : sizes) {
      benchOne(family, generate(*familyFromName(family), size, 1), repetitions);
      std::fflush(stdout);
    }
  }
}

}  // namespace circle_voronoi::bench
