// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixtures.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "circle_voronoi/io.h"

namespace circle_voronoi::test {
namespace {

const std::filesystem::path kFolder = CIRCLE_VORONOI_FIXTURES;

}  // namespace

std::vector<std::string> fixtureNames() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    if (entry.path().extension() == ".csv") names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

std::vector<Circle> readFixture(const std::string& name) {
  std::ifstream file(kFolder / (name + ".csv"));
  std::ostringstream text;
  text << file.rdbuf();
  auto circles = readCircles(text.str(), name);
  if (!file || !circles) throw std::runtime_error("cannot read the fixture " + name);
  return std::move(circles).value();
}

}  // namespace circle_voronoi::test
