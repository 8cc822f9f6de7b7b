// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixtures.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "circle_voronoi/io.h"

namespace circle_voronoi::test {
std::vector<std::string> fixtureNames() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(CIRCLE_VORONOI_FIXTURES)) {
    if (entry.path().extension() == ".csv") names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

std::string fileOfFixtures(const std::string& name) { return CIRCLE_VORONOI_FIXTURES "/" + name; }

std::string pathOfFixture(const std::string& name) { return fileOfFixtures(name + ".csv"); }

std::vector<Circle> readFixture(const std::string& name) {
  std::ifstream file(pathOfFixture(name));
  std::ostringstream text;
  text << file.rdbuf();
  auto circles = readCircles(text.str(), name);
  if (!file || !circles) throw std::runtime_error("cannot read the fixture " + name);
  return std::move(circles).value();
}

}  // namespace circle_voronoi::test
