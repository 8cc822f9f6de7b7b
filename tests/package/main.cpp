// SPDX-License-Identifier: GPL-3.0-or-later
// A project that uses the library as its users do.
#include <circle_voronoi/compute.h>
#include <circle_voronoi/io.h>

#include <array>
#include <cstdlib>
#include <iostream>

int main() {
  using namespace circle_voronoi;
  const auto circles = readCircles("0,0,1\n6,0,1\n0,8,1\n", "text");
  if (!circles) return EXIT_FAILURE;
  const auto diagram = compute(circles.value());
  if (!diagram || diagram.value().vertices.size() != 1) return EXIT_FAILURE;
  writeStatsJson(std::cout, diagram.value());
  return diagram.value().certificate.certified() ? EXIT_SUCCESS : EXIT_FAILURE;
}
