// SPDX-License-Identifier: GPL-3.0-or-later
// How wide a vehicle gets through a forest: clearest_path TREES.csv X1 Y1 X2 Y2
#include <circle_voronoi/cells.h>
#include <circle_voronoi/clearest_path.h>
#include <circle_voronoi/compute.h>
#include <circle_voronoi/io.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>

namespace cv = circle_voronoi;

int main(int count, char** arguments) {
  if (count != 6) {
    std::cerr << "Usage: clearest_path TREES.csv X1 Y1 X2 Y2\n";
    return 2;
  }
  std::ostringstream text;
  text << std::ifstream(arguments[1]).rdbuf();
  const auto trees = cv::readCircles(text.str(), arguments[1]);
  if (!trees) {
    std::cerr << trees.error().message << '\n';
    return 2;
  }
  const auto diagram = cv::compute(trees.value());
  if (!diagram) {
    std::cerr << diagram.error().message << '\n';
    return 1;
  }

  const cv::Point from = {std::atof(arguments[2]), std::atof(arguments[3])};
  const cv::Point to = {std::atof(arguments[4]), std::atof(arguments[5])};
  const cv::Cells cells(trees.value(), diagram.value());
  const cv::ClearestPath path = cv::clearestPath(cells, from, to);
  std::cout << "A disc of diameter " << 2 * std::max(path.clearance, 0.0) << " gets through, between these trees:\n";
  for (const auto e : path.edges) {
    const cv::Edge& edge = diagram.value().edges[static_cast<std::size_t>(e)];
    std::cout << edge.left << ' ' << edge.right << '\n';
  }
}
