// SPDX-License-Identifier: GPL-3.0-or-later
#include "report.h"

#include <cstdlib>
#include <iostream>
#include <sstream>

namespace circle_voronoi::test {

std::uint64_t seedOr(std::uint64_t otherwise) {
  const char* value = std::getenv("CIRCLE_VORONOI_SEED");
  const std::uint64_t seed = value == nullptr ? otherwise : std::strtoull(value, nullptr, 10);
  std::cout << "CIRCLE_VORONOI_SEED=" << seed << std::endl;
  return seed;
}

std::string describe(std::span<const Circle> circles) {
  std::ostringstream text;
  text << std::hexfloat;
  for (const Circle& c : circles) text << "\n{" << c.x << ", " << c.y << ", " << c.r << "},";
  return text.str();
}

}  // namespace circle_voronoi::test
