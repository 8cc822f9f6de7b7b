// SPDX-License-Identifier: GPL-3.0-or-later
// How densely particles are packed, each in its own cell: packing_density PARTICLES.csv
// Prints each circle, the area of its cell inside the bounding box, and the share of the cell that the circle fills.
#include <circle_voronoi/clipped_diagram.h>
#include <circle_voronoi/compute.h>
#include <circle_voronoi/io.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <numbers>
#include <string>

namespace cv = circle_voronoi;

/// The box around the circles. Precondition: there are some.
cv::Box boundingBox(const std::vector<cv::Circle>& circles) {
  const auto& [x, y, r] = circles.front();
  cv::Box box = {x - r, y - r, x + r, y + r};
  for (const cv::Circle& c : circles) {
    box = {std::min(box.minX, c.x - c.r), std::min(box.minY, c.y - c.r), std::max(box.maxX, c.x + c.r),
           std::max(box.maxY, c.y + c.r)};
  }
  return box;
}

int main(int count, char** arguments) {
  if (count != 2) {
    std::cerr << "Usage: packing_density PARTICLES.csv\n";
    return 2;
  }
  std::ifstream file(arguments[1], std::ios::binary);
  file.peek();  // Fails for a missing file and for a folder.
  if (!file.is_open() || file.bad()) {
    std::cerr << "Cannot read " << arguments[1] << ".\n";
    return 1;
  }
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto particles = cv::readCircles(text, arguments[1]);
  if (!particles || particles.value().empty()) {
    std::cerr << (particles ? "There are no particles." : particles.error().message) << '\n';
    return 2;
  }
  const auto& circles = particles.value();
  const auto diagram = cv::compute(circles);
  if (!diagram) {
    std::cerr << diagram.error().message << '\n';
    return 1;
  }

  const auto box = cv::Region::from(boundingBox(circles));
  if (!box) {
    std::cerr << box.error().message << '\n';
    return 2;
  }
  const auto clipped = cv::ClippedDiagram::from(*diagram, *box);
  if (!clipped) {
    std::cerr << clipped.error().message << '\n';
    return 1;
  }
  std::cout << "circle,area,density\n";
  for (cv::CircleIndex i = 0; i < static_cast<std::int32_t>(circles.size()); ++i) {
    if (!diagram->hasCell(i)) continue;
    const double area = clipped->area(i);
    const double r = circles[static_cast<std::size_t>(i)].r;
    std::cout << i << ',' << area << ',' << std::numbers::pi * r * r / area << '\n';
  }
}
