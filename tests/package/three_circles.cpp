// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <vector>

#include "circle_voronoi/compute.h"

int main() {
  const std::vector<circle_voronoi::Circle> circles = {{0, 0, 1}, {4, 0, 1}, {2, 1, 0}};
  const auto diagram = circle_voronoi::compute(circles);
  if (!diagram) {
    std::cout << circle_voronoi::errorCodeName(diagram.error().code) << '\n';
  } else {
    std::cout << diagram.value().vertices.size() << " vertex\n";
  }
}
