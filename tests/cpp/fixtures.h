// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "circle_voronoi/circle.h"

namespace circle_voronoi::test {

/// The names of all files of tests/fixtures that hold circles, without folder and extension, sorted.
std::vector<std::string> fixtureNames();

/// The path of a file or folder in tests/fixtures.
std::string fileOfFixtures(const std::string& name);

/// The path of a fixture's file.
std::string pathOfFixture(const std::string& name);

std::vector<Circle> readFixture(const std::string& name);

}  // namespace circle_voronoi::test
