// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the widest vehicle that gets through a forest: clearest_path TREES.csv X1 Y1 X2 Y2
#include <circle_voronoi/cells.h>
#include <circle_voronoi/clearest_path.h>
#include <circle_voronoi/compute.h>
#include <circle_voronoi/io.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

namespace cv = circle_voronoi;

int main(int count, char** arguments) {
  if (count != 6) {
    std::cerr << "Usage: clearest_path TREES.csv X1 Y1 X2 Y2\n";
    return 2;
  }
  std::array<double, 4> coordinates{};
  for (int i = 0; i < 4; ++i) {
    char* end = nullptr;
    coordinates[static_cast<std::size_t>(i)] = std::strtod(arguments[i + 2], &end);
    if (end == arguments[i + 2] || *end != '\0') {
      std::cerr << "Not a number: " << arguments[i + 2] << '\n';
      return 2;
    }
  }
  std::ifstream file(arguments[1], std::ios::binary);
  file.peek();  // Fails for a missing file and for a folder.
  if (!file.is_open() || file.bad()) {
    std::cerr << "Cannot read " << arguments[1] << ".\n";
    return 1;
  }
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto trees = cv::readCircles(text, arguments[1]);
  if (!trees || trees.value().empty()) {
    std::cerr << (trees ? "There are no trees." : trees.error().message) << '\n';
    return 2;
  }
  const auto diagram = cv::compute(trees.value());
  if (!diagram) {
    std::cerr << diagram.error().message << '\n';
    return 1;
  }

  const cv::Point from = {coordinates[0], coordinates[1]};
  const cv::Point to = {coordinates[2], coordinates[3]};
  const cv::ClearestPath path = cv::clearestPath(diagram.value(), from, to);
  std::cout << "A disc of diameter " << 2 * std::max(path.clearance, 0.0) << " gets through, between these trees:\n";
  for (const auto e : path.edges) {
    const cv::Edge& edge = diagram.value().edges[static_cast<std::size_t>(e)];
    std::cout << edge.left << ' ' << edge.right << '\n';
  }
}
